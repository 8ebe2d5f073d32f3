/** The places of the page, in the order in which the eye and the focus go. */
export function layOut(host: HTMLElement) {
  host.classList.add('accuracy');
  const area = (name: string, parent = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = name;
    parent.append(element);
    return element;
  };
  const head = area('acc-head');
  const plot = area('acc-plot');
  const places = {
    head,
    frontier: area('acc-plot-body', plot),
    empty: area('acc-plot-empty', plot),
    bar: area('acc-bar'),
    hardHead: area('acc-part'),
  };
  const hard = area('acc-hard');
  return {
    ...places,
    hardness: area('acc-plot-body', hard),
    hardWords: area('acc-words', hard),
    ray: area('acc-part acc-ray'),
    foot: area('acc-part acc-foot'),
  };
}
