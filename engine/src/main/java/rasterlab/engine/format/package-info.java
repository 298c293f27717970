/**
 * Describes values outside the engine as data: which fields there are, what each may be and what it
 * becomes.
 *
 * <p>From one such description values are read, refused with their place, written and documented.
 * Nothing here knows a text format; JSON is read and written elsewhere. Start with {@link
 * rasterlab.engine.format.Shape}.
 */
package rasterlab.engine.format;
