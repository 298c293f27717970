/**
 * The labs of the window in their order, and from them the card of each topic: the one place where
 * a new lab is listed.
 */
package rasterlab.app.rooms;
