import { InvalidInput } from '../../math/index.ts';
import { budgetCsv } from '../../panels/picture-budget.ts';
import { growthCsv } from '../../panels/picture-growth.ts';
import { sceneFromJson, sceneToJson } from '../../scene/json.ts';
import type { Dispatch } from '../../state/actions.ts';
import { ledgerCsv } from '../../state/picture/ledger.ts';
import { textOfScene } from '../../state/picture/scene-link.ts';
import { changed } from '../../state/picture/settings.ts';
import type { Picture } from '../../tracer/compare.ts';
import type { ExportItem } from '../export-dialog.ts';
import type { BudgetState } from './budget.ts';
import type { GrowthState } from './growth.ts';
import type { PictureModel } from './picture-model.ts';

/**
 * What can be taken from the page: the picture that is `shown`, its scene, its ledger, how its
 * price grows.
 */
export function pictureExports(
  model: () => PictureModel | null,
  shown: () => Picture | null,
  growth: () => GrowthState | null,
  budget: () => BudgetState | null,
): readonly ExportItem[] {
  const grown = growth();
  const sought = budget();
  const text = (of: (model: PictureModel) => string) => (): string => {
    const now = model();
    return now ? of(now) : '';
  };
  return [
    {
      id: 'picture-png',
      title: 'the picture as PNG',
      file: 'graze-picture.png',
      type: 'image/png',
      text: null,
      blob: () => pictureBlob(shown()),
    },
    {
      id: 'scene-json',
      title: 'the scene as JSON',
      file: 'graze-scene.json',
      type: 'application/json',
      text: text(({ picture }) => sceneToJson(picture.scene)),
      blob: null,
    },
    {
      id: 'ledger-csv',
      title: 'the ledger as CSV',
      file: 'graze-ledger.csv',
      type: 'text/csv',
      text: text(({ ledger }) => ledgerCsv(ledger)),
      blob: null,
    },
    ...(grown
      ? [
          {
            id: 'growth-csv',
            title: 'how the price grows as CSV',
            file: 'graze-growth.csv',
            type: 'text/csv',
            text: () => growthCsv(growth() ?? grown),
            blob: null,
          },
        ]
      : []),
    ...(sought
      ? [
          {
            id: 'budget-csv',
            title: 'pictures within the budget as CSV',
            file: 'graze-budget.csv',
            type: 'text/csv',
            text: () => budgetCsv(sought.budget, budget() ?? sought),
            blob: null,
          },
        ]
      : []),
  ];
}

/** At its own size, pixel by pixel; null while nothing is traced. */
function pictureBlob(frame: Picture | null): Promise<Blob | null> {
  if (!frame) return Promise.resolve(null);
  const canvas = document.createElement('canvas');
  canvas.width = frame.width;
  canvas.height = frame.height;
  const data = new ImageData(new Uint8ClampedArray(frame.rgba), frame.width, frame.height);
  canvas.getContext('2d')?.putImageData(data, 0, 0);
  return new Promise((resolve) => canvas.toBlob(resolve));
}

/**
 * Takes a file that holds a scene; false for one that holds something else. A broken scene says
 * what is wrong with it.
 */
export function openScene(text: string, dispatch: Dispatch): boolean {
  if (!looksLikeScene(text)) return false;
  try {
    const scene = textOfScene(sceneFromJson(text));
    dispatch({
      type: 'settings',
      values: changed({ scene, pixel: '', on: '', off: '' }),
    });
    dispatch({ type: 'dismiss' });
  } catch (error) {
    if (!(error instanceof InvalidInput)) throw error;
    dispatch({ type: 'say', problems: [`this scene was not opened: ${error.message}`] });
  }
  return true;
}

function looksLikeScene(text: string): boolean {
  try {
    const data: unknown = JSON.parse(text);
    if (typeof data !== 'object' || data === null) return false;
    return 'things' in data || ('graze' in data && data.graze === 'scene');
  } catch {
    // JSON with an error may still be a scene: reading it then reports the place of the error.
    return /"things"|"graze"\s*:\s*"scene"/.test(text);
  }
}
