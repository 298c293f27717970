package rasterlab.app.cli.run;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.app.outcome.Complaint;

/** What the engine says against an input, with the place that it names as a JSON pointer. */
final class EngineRefusal {
    /** Such as "vertices[3].x must be from …". */
    private static final Pattern PLACED =
            Pattern.compile("(\\w+)((?:\\[\\d+])*)(?:\\.([xyz]))? (must .*)", Pattern.DOTALL);

    private EngineRefusal() {}

    static Complaint complaint(IllegalArgumentException refusal) {
        Matcher placed = PLACED.matcher(refusal.getMessage());
        if (!placed.matches()) return Complaint.badInput("/: " + refusal.getMessage());
        String indices = placed.group(2).replace("]", "").replace('[', '/');
        String axis = placed.group(3) == null ? "" : "/" + "xyz".indexOf(placed.group(3));
        return Complaint.badInput("/" + placed.group(1) + indices + axis + ": " + placed.group(4));
    }
}
