/**
 * The command line {@code ./lab}: its list of commands, and those that start something else, such
 * as the window. The other commands stand in the packages within, by what they work on.
 *
 * <p>Start with {@link rasterlab.app.cli.Lab}; exit codes are in {@code ExitCode}.
 */
package rasterlab.app.cli;
