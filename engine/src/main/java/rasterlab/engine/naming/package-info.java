/**
 * How things are found by the names that users type.
 *
 * <p>Start with {@link rasterlab.engine.naming.Named}.
 */
package rasterlab.engine.naming;
