package rasterlab.app.opengl;

import java.util.ArrayList;
import java.util.List;

/** A call in lines of a width, each but the first indented; without breaks it is the call again. */
final class CallLines {
    /** Columns before each line but the first. */
    static final int INDENT = 4;

    /**
     * Where a line ends: between arguments, but within no vector that has room in a line; else
     * behind a bracket, else in a name.
     */
    private static final String[] ENDS = {" ", "(", "_"};

    private CallLines() {}

    /**
     * @param columns the most that a line has with its indent; fewer than a few letters are taken
     *     to be more
     */
    static List<String> of(String call, int columns) {
        int most = Math.max(2 * INDENT, columns);
        var lines = new ArrayList<String>();
        String rest = call;
        int room = most;
        while (rest.length() > room) {
            int end = end(rest, room);
            lines.add(rest.substring(0, end).stripTrailing());
            rest = rest.substring(end).stripLeading();
            room = most - INDENT;
        }
        lines.add(rest);
        return lines;
    }

    private static int end(String rest, int room) {
        int end = anyEnd(rest, room);
        int open = rest.lastIndexOf('{', end - 1);
        int close = rest.indexOf('}', Math.max(0, open));
        boolean splits = open > 0 && close >= end && close - open < room - INDENT;
        return splits ? open : end;
    }

    private static int anyEnd(String rest, int room) {
        for (String each : ENDS) {
            int last = rest.lastIndexOf(each, each.equals(" ") ? room : room - 1);
            if (last > 0) return last + 1;
        }
        return room;
    }
}
