/**
 * The tabs of the window: their titles in rows, their panels, which are made when they are first
 * chosen, and the keys that belong to the window. Start reading at {@link TabbedLabs}.
 */
package rasterlab.app.shell.tab;
