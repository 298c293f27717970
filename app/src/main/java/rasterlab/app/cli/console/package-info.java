/**
 * The parts that every command shares: its streams and languages, complaints and the exit codes
 * they have, tables and JSON as they are printed, names and numbers as options take them. Start
 * reading at {@link rasterlab.app.cli.console.Console}.
 */
package rasterlab.app.cli.console;
