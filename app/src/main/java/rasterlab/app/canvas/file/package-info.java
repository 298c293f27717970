/**
 * Files and the clipboard: choosing, dropping, reading again and writing what a lab shows. Pictures
 * are written as PNG or SVG, scenes as JSON; the event thread never waits for the disk. Start
 * reading at {@link LastFolderChooser} and {@link PictureSaving}.
 */
package rasterlab.app.canvas.file;
