/**
 * The lab of views: an object on its way from its own frame to the world, to the eye, to the
 * picture plane and to the pixels of a window, stage by stage.
 *
 * <p>Each stage is a list of named matrices and names the space of its coordinates. Start with
 * {@link rasterlab.app.coordinates.view.ViewStages}; {@link
 * rasterlab.app.coordinates.view.ViewLabModel} knows no Swing.
 */
package rasterlab.app.coordinates.view;
