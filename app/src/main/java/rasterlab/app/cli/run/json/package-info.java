/**
 * JSON as {@code ./lab run} reads and writes it: nothing accepted that was not asked for, each
 * complaint with its place, numbers that read back exactly.
 *
 * <p>Start with {@link rasterlab.app.cli.run.json.StrictJson}.
 */
package rasterlab.app.cli.run.json;
