package rasterlab.app.hazard;

import java.util.regex.Pattern;

/** A command on a page: its lines break between words, never behind a hyphen in one. */
public final class CommandHtml {
    /** The rule that a page's style needs. */
    public static final String STYLE = "pre span{white-space:nowrap}\n";

    /** A word with a hyphen that is short enough for the narrowest screen. */
    private static final Pattern HYPHENATED = Pattern.compile("(?<!\\S)(?=\\S*-)\\S{2,36}(?!\\S)");

    private CommandHtml() {}

    public static String of(String command) {
        String words =
                HYPHENATED.matcher(HazardHtml.escaped(command)).replaceAll("<span>$0</span>");
        return "<pre>" + words + "</pre>\n";
    }
}
