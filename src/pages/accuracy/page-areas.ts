/** Creates the areas of the page in reading and focus order. */
export function createAreas(host: HTMLElement) {
  host.classList.add('accuracy');
  const area = (name: string, parent = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = name;
    parent.append(element);
    return element;
  };
  const areaOf = (part: string, name: string): HTMLElement => {
    const element = area(name);
    element.dataset.part = part;
    return element;
  };
  const atlas = areaOf('atlas', 'acc-atlas');
  const head = areaOf('prices', 'acc-head');
  const plot = areaOf('prices', 'acc-plot');
  const places = {
    atlas,
    head,
    plot,
    frontier: area('acc-plot-body', plot),
    empty: area('acc-plot-empty', plot),
    bar: areaOf('prices', 'acc-bar'),
    hardHead: areaOf('hardness', 'acc-part'),
  };
  const hard = areaOf('hardness', 'acc-hard');
  return {
    ...places,
    hard,
    hardness: area('acc-plot-body', hard),
    hardWords: area('acc-words', hard),
    ready: areaOf('prices', 'acc-part acc-ready'),
    ray: areaOf('ray', 'acc-part acc-ray'),
    foot: areaOf('rest', 'acc-part acc-foot'),
  };
}
