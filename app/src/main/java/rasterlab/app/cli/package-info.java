/**
 * The command line {@code ./lab}: one class per command, nothing but text, JSON and pictures.
 *
 * <p>Start with {@link rasterlab.app.cli.Lab}; exit codes are in {@code ExitCode}.
 */
package rasterlab.app.cli;
