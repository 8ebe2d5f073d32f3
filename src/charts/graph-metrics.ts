import { sizeOf } from '../ui/zoom.ts';
import { MARGINS, type Metrics } from './graph-frame.ts';

/**
 * Watches the size of the host and, by a hidden element as large as one caption em and ten mark
 * pixels, the type and mark sizes of the theme. `slot` is where the graph is drawn.
 */
export function watchMetrics(host: HTMLElement, changed: () => void) {
  const probe = document.createElement('span');
  probe.className = 'graph-probe';
  const slot = document.createElement('div');
  slot.className = 'graph-slot';
  host.append(probe, slot);
  let metrics: Metrics | null = null;
  const observer = new ResizeObserver(() => {
    const next = measured(host, probe);
    if (isSame(metrics, next)) return;
    metrics = next;
    changed();
  });
  observer.observe(host);
  observer.observe(probe);
  return {
    slot,
    metrics() {
      metrics ??= measured(host, probe);
      return metrics;
    },
    dispose() {
      observer.disconnect();
      probe.remove();
      slot.remove();
    },
  };
}

/** Null while the host is not shown, or has no room for a plot within its margins. */
function measured(host: HTMLElement, probe: HTMLElement): Metrics | null {
  const { clientWidth: width, clientHeight: height } = host;
  const { width: em, height: tenMarks } = sizeOf(probe);
  const hasRoom = em > 0 && width > MARGINS.width * em && height > MARGINS.height * em;
  return hasRoom ? { width, height, em, mark: tenMarks / 10 } : null;
}

function isSame(a: Metrics | null, b: Metrics | null): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
