/**
 * How the window looks and what it keeps between runs: theme, language, size of type, tab and
 * place, in a small file of the user's; and what is wrong with such files. Start reading at {@link
 * SettingsFile}.
 */
package rasterlab.app.shell.settings;
