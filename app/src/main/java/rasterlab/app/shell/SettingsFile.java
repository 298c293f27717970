package rasterlab.app.shell;

import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.function.Consumer;
import rasterlab.app.language.Language;

/**
 * The window's settings in a small file of the user's.
 *
 * <p>A broken or unwritable file is told once and does no harm: the window opens as on the first
 * run.
 */
public final class SettingsFile {
    private final Path file;
    private final Consumer<String> problem;
    private boolean told;

    /**
     * @param problem told, at most once, what is wrong with the file, in one English line
     */
    public SettingsFile(Path file, Consumer<String> problem) {
        this.file = file;
        this.problem = problem;
    }

    /**
     * The file's usual place: the system property {@code rasterlab.settings} if set, else {@code
     * rasterlab/window.properties} in the folder where the system keeps its users' settings.
     *
     * @param environment the process's environment
     * @param properties the system properties
     */
    public static Path usual(Map<String, String> environment, Properties properties) {
        String asked = properties.getProperty("rasterlab.settings", "");
        if (!asked.isEmpty()) return Path.of(asked);
        String home = properties.getProperty("user.home");
        String system = properties.getProperty("os.name").toLowerCase(Locale.ROOT);
        Path folder;
        if (system.contains("win") && environment.containsKey("APPDATA"))
            folder = Path.of(environment.get("APPDATA"));
        else if (system.contains("mac")) folder = Path.of(home, "Library", "Application Support");
        else
            folder =
                    Optional.ofNullable(environment.get("XDG_CONFIG_HOME"))
                            .filter(path -> path.startsWith("/"))
                            .map(Path::of)
                            .orElse(Path.of(home, ".config"));
        return folder.resolve("rasterlab").resolve("window.properties");
    }

    /** Where the file is, and other files of the user's beside it. */
    Path folder() {
        return file.toAbsolutePath().getParent();
    }

    /** What the file holds; the given settings where it holds nothing or nonsense. */
    public LabSettings load(LabSettings otherwise) {
        if (!Files.exists(file)) return otherwise;
        try (var in = Files.newBufferedReader(file)) {
            var kept = new Properties();
            kept.load(in);
            return parse(kept);
        } catch (IOException | IllegalArgumentException e) {
            tell("cannot use the window settings in " + file + ": " + reason(e));
            return otherwise;
        }
    }

    public void save(LabSettings settings) {
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            Files.writeString(file, format(settings));
        } catch (IOException e) {
            tell("cannot keep the window settings in " + file + ": " + reason(e));
        }
    }

    private static String format(LabSettings settings) {
        String bounds =
                settings.bounds()
                        .map(b -> b.x + " " + b.y + " " + b.width + " " + b.height)
                        .orElse("");
        return "theme=%s%nlanguage=%s%ntext=%d%ntab=%s%nbounds=%s%nmaximised=%s%n"
                .formatted(
                        settings.look().theme(),
                        settings.look().language(),
                        settings.look().textPercent(),
                        settings.tab(),
                        bounds,
                        settings.maximised());
    }

    private static LabSettings parse(Properties kept) {
        return new LabSettings(
                new LabLook(
                        LabTheme.valueOf(value(kept, "theme")),
                        Language.valueOf(value(kept, "language")),
                        Integer.parseInt(kept.getProperty("text", "100").strip())),
                value(kept, "tab"),
                bounds(value(kept, "bounds")),
                Boolean.parseBoolean(value(kept, "maximised")));
    }

    private static String value(Properties kept, String key) {
        String value = kept.getProperty(key);
        if (value == null) throw new IllegalArgumentException("'" + key + "' is missing");
        return value.strip();
    }

    private static Optional<Rectangle> bounds(String text) {
        if (text.isEmpty()) return Optional.empty();
        int[] numbers = Arrays.stream(text.split(" +")).mapToInt(Integer::parseInt).toArray();
        if (numbers.length != 4 || numbers[2] < 1 || numbers[3] < 1)
            throw new IllegalArgumentException(
                    "'bounds' needs x y width height, both sizes at least 1, got '" + text + "'");
        return Optional.of(new Rectangle(numbers[0], numbers[1], numbers[2], numbers[3]));
    }

    private static String reason(Exception e) {
        return e instanceof IOException ? e.toString() : e.getMessage();
    }

    private void tell(String line) {
        if (!told) problem.accept(line);
        told = true;
    }
}
