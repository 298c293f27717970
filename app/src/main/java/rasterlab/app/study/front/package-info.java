/**
 * The charts of speed and accuracy that files, pages and the tab share: the front of one workload,
 * growth with size, and what is best where. They draw on any graphics, in a size of its own; names
 * stand at the lines' ends, and no line to a name crosses another. Start with {@link
 * rasterlab.app.study.front.FrontChart}.
 */
package rasterlab.app.study.front;
