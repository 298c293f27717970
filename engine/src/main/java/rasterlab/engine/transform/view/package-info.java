/**
 * Topic {@code view}: the view by spherical coordinates as one matrix and taken apart, to count
 * what each costs.
 *
 * <p>World: right-handed, z up. Eye: left-handed, x right, y up, z forward. Start with {@link
 * rasterlab.engine.transform.view.DecomposedView}.
 */
package rasterlab.engine.transform.view;
