/** A view that is attached to the page: it renders a model, and frees its resources at the end. */
export interface Mounted<Model> {
  render(model: Model): void;
  dispose(): void;
}
