/** A view on the page: shows a model, and frees what it holds. */
export interface Mounted<Model> {
  render(model: Model): void;
  dispose(): void;
}
