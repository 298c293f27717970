package rasterlab.app.shell.settings;

import java.awt.Rectangle;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.Stream;
import rasterlab.app.canvas.file.LastChosen;
import rasterlab.app.canvas.file.PictureForm;
import rasterlab.app.language.Language;

/** The window's settings as lines {@code key=value}. */
final class SettingsText {
    private static final List<Object> YES_OR_NO = List.of(true, false);

    private SettingsText() {}

    /** The lines hold something else than the window writes. */
    static final class UnreadableSettings extends Exception {
        private static final long serialVersionUID = 1L;

        private final transient Problem problem;

        UnreadableSettings(String key, Object... arguments) {
            problem = Problem.of(key, arguments);
        }

        Problem problem() {
            return problem;
        }
    }

    static String write(LabSettings settings) {
        String bounds =
                settings.bounds()
                        .map(b -> b.x + " " + b.y + " " + b.width + " " + b.height)
                        .orElse("");
        String folder = settings.chosen().folder().map(Path::toString).orElse("");
        return """
                theme=%s
                language=%s
                text=%d
                tab=%s
                bounds=%s
                maximised=%s
                controls=%s
                folder=%s
                picture=%s
                """
                .formatted(
                        settings.look().theme(),
                        settings.look().language(),
                        settings.look().textPercent(),
                        settings.tab(),
                        bounds,
                        settings.maximised(),
                        settings.controls(),
                        escaped(folder),
                        settings.chosen().form());
    }

    /** The text as Properties reads it: a folder may have any name. */
    private static String escaped(String text) {
        return text.replace("\\", "\\\\")
                .replace("\n", "\\n")
                .replace("\r", "\\r")
                .replace("\f", "\\f")
                .replace("\t", "\\t");
    }

    /**
     * @throws UnreadableSettings naming the key, the value and what is allowed
     */
    static LabSettings read(Properties kept) throws UnreadableSettings {
        var look =
                new LabLook(
                        one(kept, "theme", List.of(LabTheme.values())),
                        one(kept, "language", List.of(Language.values())),
                        kept.containsKey("text") ? one(kept, "text", LabLook.SIZES) : 100);
        boolean controls =
                !kept.containsKey("controls") || one(kept, "controls", YES_OR_NO).equals(true);
        return new LabSettings(
                look,
                value(kept, "tab"),
                bounds(value(kept, "bounds")),
                one(kept, "maximised", YES_OR_NO).equals(true),
                controls,
                chosen(kept));
    }

    private static LastChosen chosen(Properties kept) throws UnreadableSettings {
        PictureForm form = LastChosen.NONE.form();
        if (kept.containsKey("picture")) form = one(kept, "picture", List.of(PictureForm.values()));
        return new LastChosen(folder(kept.getProperty("folder", "")), form);
    }

    /** The folder; empty also where its name cannot be written in the encoding of this run. */
    private static Optional<Path> folder(String name) {
        try {
            return Optional.of(name).filter(some -> !some.isEmpty()).map(Path::of);
        } catch (InvalidPathException unwritable) {
            return Optional.empty();
        }
    }

    private static String value(Properties kept, String key) throws UnreadableSettings {
        String value = kept.getProperty(key);
        if (value == null) throw new UnreadableSettings("settings.missing", key);
        return value.strip();
    }

    private static <T> T one(Properties kept, String key, List<T> allowed)
            throws UnreadableSettings {
        String value = value(kept, key);
        for (T each : allowed) if (each.toString().equals(value)) return each;
        String names = String.join(", ", allowed.stream().map(Object::toString).toList());
        throw new UnreadableSettings("settings.choice", key, names, value);
    }

    private static Optional<Rectangle> bounds(String text) throws UnreadableSettings {
        if (text.isEmpty()) return Optional.empty();
        if (!text.matches("-?\\d{1,9}( +-?\\d{1,9}){3}"))
            throw new UnreadableSettings("settings.bounds", text);
        int[] n = Stream.of(text.split(" +")).mapToInt(Integer::parseInt).toArray();
        if (n[2] < 1 || n[3] < 1) throw new UnreadableSettings("settings.bounds", text);
        return Optional.of(new Rectangle(n[0], n[1], n[2], n[3]));
    }
}
