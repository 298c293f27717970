/**
 * Work beside the event thread and what comes of it: one piece at a time that can be cancelled, or
 * only the newest of many; listeners, and the user's earlier choices for undo and redo. Start
 * reading at {@link LatestOnly} and {@link History}.
 */
package rasterlab.app.canvas.work;
