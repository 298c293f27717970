package rasterlab.exercises.formula;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.exercises.score.Message;

/**
 * Looks a formula through before the library does, which trusts its text: it would run commands
 * that statements have no need of, let signs grow twofold with each level until memory is full, and
 * guess where something is missing.
 */
final class TexCheck {
    private static final int LONGEST = 2000;
    private static final int DEEPEST = 16;
    private static final Pattern NAME = Pattern.compile("\\s*\\{([^{}]*)\\}");
    private static final Pattern COLUMNS = Pattern.compile("\\s*\\{[lcr| ]{1,40}\\}");

    private final String tex;
    private final Deque<Level> open = new ArrayDeque<>();
    private int at;
    private Message mistake = Message.NONE;

    /**
     * A group that has begun and not ended.
     *
     * @param end what ends it; of a command, its name
     * @param lacking arguments that are still to come; 0 where {@code end} ends it
     * @param total arguments in all
     */
    private record Level(String end, int lacking, int total) {
        boolean isCommand() {
            return lacking > 0;
        }
    }

    private TexCheck(String tex) {
        this.tex = tex;
    }

    /** The fault of the formula; empty where none was found. */
    static Optional<Message> mistake(String tex) {
        if (tex.isBlank()) return Optional.of(Message.of("formula.empty"));
        if (tex.length() > LONGEST)
            return Optional.of(Message.of("formula.long", tex.length(), LONGEST));
        var check = new TexCheck(tex);
        check.run();
        return Optional.of(check.mistake).filter(found -> !found.isEmpty());
    }

    private void run() {
        while (at < tex.length() && mistake.isEmpty()) next(tex.charAt(at++));
        if (mistake.isEmpty() && !open.isEmpty()) missing(open.peek());
    }

    private void next(char c) {
        switch (c) {
            case '\\' -> command();
            case '{' -> push(new Level("}", 0, 0));
            case '}' -> pop("}");
            case '[' -> option();
            case ']' -> {
                if (!open.isEmpty() && open.peek().end().equals("]")) open.pop();
                else item();
            }
            case '^', '_' -> push(new Level(String.valueOf(c), 1, 1));
            case '$', '%', '#' -> misplaced();
            case '&' -> {
                if (open.isEmpty() || !open.peek().end().startsWith("\\end")) misplaced();
            }
            case ' ', '\t', '\n' -> {}
            default -> {
                if (TexCommands.allows(c)) item();
                else misplaced();
            }
        }
    }

    /** Something is complete, and with it what awaited it as its last argument. */
    private void item() {
        while (!open.isEmpty() && open.peek().isCommand()) {
            Level level = open.pop();
            if (level.lacking() > 1) {
                open.push(new Level(level.end(), level.lacking() - 1, level.total()));
                return;
            }
        }
    }

    private void option() {
        Level level = open.peek();
        boolean belongs =
                level != null
                        && level.isCommand()
                        && level.lacking() == level.total()
                        && TexCommands.takesOptions(level.end().substring(1));
        if (belongs) push(new Level("]", 0, 0));
        else item();
    }

    private void command() {
        String name = name();
        switch (name) {
            case "begin", "end" -> environment(name);
            case "left" -> {
                push(new Level("\\right", 0, 0));
                delimiter(name);
            }
            case "right" -> {
                delimiter(name);
                pop("\\right");
            }
            case "middle" -> delimiter(name);
            default -> named(name);
        }
    }

    private void named(String name) {
        int arguments = TexCommands.arguments(name);
        if (!TexCommands.allows(name)) unknown("\\" + name);
        else if (arguments > 0) push(new Level("\\" + name, arguments, arguments));
        else item();
    }

    /** The name after the backslash that was just read. */
    private String name() {
        int start = at;
        while (at < tex.length() && letter(tex.charAt(at))) at++;
        if (at == start && at < tex.length()) at++;
        return tex.substring(start, at);
    }

    private static boolean letter(char c) {
        return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z';
    }

    /** Reads the bracket that grows. */
    private void delimiter(String command) {
        while (at < tex.length() && tex.charAt(at) == ' ') at++;
        if (at == tex.length()) {
            mistake = Message.of("formula.argument", "\\" + command);
            return;
        }
        char c = tex.charAt(at++);
        if (c != '\\') {
            if ("()[]/|.<>".indexOf(c) < 0) misplaced();
            return;
        }
        String name = name();
        if (!TexCommands.allows(name) || TexCommands.arguments(name) > 0) unknown("\\" + name);
    }

    private void environment(String which) {
        Matcher name = NAME.matcher(tex).region(at, tex.length());
        boolean named = name.lookingAt();
        if (!named || !TexCommands.allowsEnvironment(name.group(1))) {
            unknown("\\" + which + (named ? name.group().strip() : ""));
            return;
        }
        at = name.end();
        String end = "\\end{" + name.group(1) + "}";
        if (which.equals("end")) pop(end);
        else push(new Level(end, 0, 0));
        if (which.equals("begin") && name.group(1).equals("array")) columns();
    }

    private void columns() {
        Matcher columns = COLUMNS.matcher(tex).region(at, tex.length());
        if (columns.lookingAt()) at = columns.end();
        else mistake = Message.of("formula.columns");
    }

    private void push(Level level) {
        open.push(level);
        if (open.size() > DEEPEST) mistake = Message.of("formula.deep", DEEPEST);
    }

    private void pop(String end) {
        if (!mistake.isEmpty()) return;
        Level level = open.peek();
        if (level == null) mistake = Message.of("formula.unopened", end);
        else if (level.isCommand()) missing(level);
        else if (!level.end().equals(end))
            mistake = Message.of("formula.crossed", end, level.end());
        else {
            open.pop();
            item();
        }
    }

    private void missing(Level level) {
        String key = level.isCommand() ? "formula.argument" : "formula.unclosed";
        mistake = Message.of(key, level.end());
    }

    private void unknown(String command) {
        mistake = Message.of("formula.unknown", command);
    }

    private void misplaced() {
        int end = tex.offsetByCodePoints(at - 1, 1);
        mistake = Message.of("formula.character", tex.substring(at - 1, end), at);
    }
}
