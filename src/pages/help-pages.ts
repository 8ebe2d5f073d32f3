import { html, type TemplateResult } from 'lit';
import type { PageId } from '../state/state.ts';

/** Help on each page: its purpose, and controls that have no label. */
export const HELP: Readonly<Record<PageId, TemplateResult>> = {
  explore: html`<h3>In the scene</h3>
    <p>Drag E, the tip of d, the shape’s own point or its radius; drag the background to look from
      elsewhere, turn the wheel or pinch to come closer. With the keyboard: Tab to a handle,
      arrows move it along x and y, Page Up and Page Down along z, Shift makes the steps fine, Alt
      lets go of the grid. On the scene itself the arrows turn it, + and − zoom, 0 goes back.</p>
    <h3>Hearing the ray</h3>
    <p>m lets f(t) be heard from E to the end of the graph: a pitch against a steady tone, which
      it meets where f is 0, higher for f above 0, lower below. A click is a root; inside the
      shape there is silence. A flat shape has no inside: there f(t) is the signed distance to
      the plane times |N|.</p>`,
  lesson: html`<h3>This page</h3>
    <p>A lesson goes step by step: Page Down and Page Up turn, wherever the focus is, and first show
      what is hidden. What a step leaves free is moved by the slider in its text, or in the scene.
      Edit changes a step where it stands; a lesson of one’s own is a text file that can be opened,
      dropped on the page, saved, and sent as a link.</p>`,
  accuracy: html`<h3>This page</h3>
    <p>Times are measured on this device, briefly as soon as the page is at rest, on rays of the
      chosen family, by the same code that the project’s bench runs; “Measure longer” refines
      them. Until then faint marks show what the bench measured of typical rays. SIMD kernels are
      compared with SIMD kernels, TypeScript with TypeScript; each price is a multiple of the
      textbook formula’s in the same. Rays are met in random order, or hits first and misses
      then.</p>
    <p>A point of a plot is a button: above it chooses its method, below it shows that method’s
      worst ray there, which opens in Explore.</p>
    <p>The table takes the ray of Explore through every method; the row that is chosen is the
      method of Explore and Picture too. Bold digits are right, faded ones are not. Every number
      of the ray can be moved by one double, with the buttons or, on them, with Up and Down.</p>`,
  picture: html`<h3>This page</h3>
    <p>Only what the scene needs is simulated; the list beside the picture says what that was,
      what it cost, and what was left out and why. “Scene” opens the forms in which everything can
      be changed; shapes can then be dragged in the picture too.</p>
    <p>On the picture the arrows move a cursor from pixel to pixel, Page Up, Page Down and Ctrl
      with an arrow farther, and Enter follows the rays of that pixel. A drag turns the camera, with
      Shift it moves it; by keys these are Shift, and Shift with Ctrl, and an arrow; + and − come
      nearer and go back. On the divider of a
      comparison the arrows move it, with Shift a tenth as far, Home and End to the sides.</p>`,
  check: html`<h3>This page</h3>
    <p>Enter hands in an answer. Set and seed are in the link: the same two pose the same
      questions everywhere. What was answered and typed stays on this device, and survives a
      reload; only a package for a course system reports it there, and says so.</p>
    <p>An own program runs in a frame without network, storage or page, in a worker of its own
      that is ended when it falls silent for a second.</p>`,
};

export const ABOUT: Readonly<Record<PageId, string>> = {
  explore:
    'Choose a shape and move the ray R(t) = E + t d. Everything else follows: the coefficients, ' +
    'the roots, the points and the normals. t counts in lengths of d.',
  lesson:
    'A few steps, each with something to see and something to find out. The numbers in the text ' +
    'are those of the scene beside it.',
  accuracy:
    'How many digits each method gets right, what each digit costs, and where the lost ' +
    'ones go.',
  picture:
    'A ray-traced picture of a scene, and the account of what it took. Every ray in it is ' +
    'answered by the method that is chosen.',
  check:
    'Questions whose wrong answers are explained, own numbers marked line by line, and own ' +
    'programs run against exact cases.',
};
