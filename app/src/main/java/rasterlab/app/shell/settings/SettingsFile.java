package rasterlab.app.shell.settings;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.function.Consumer;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;

/**
 * The window's settings in a small file of the user's.
 *
 * <p>A broken or unwritable file is told once and does no harm: the window opens as on the first
 * run.
 */
public final class SettingsFile {
    private final Path file;
    private final Consumer<Problem> problem;
    private boolean told;

    /** Whether the file cannot be used and is still there: nothing is written over it. */
    private boolean inTheWay;

    /**
     * @param problem told, at most once, what is wrong with the file
     */
    public SettingsFile(Path file, Consumer<Problem> problem) {
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
    public Path folder() {
        return file.toAbsolutePath().getParent();
    }

    /** The settings in the file; the given ones where it holds nothing or nonsense. */
    public synchronized LabSettings load(LabSettings otherwise) {
        if (!Files.exists(file)) return otherwise;
        Optional<String> obstacle = FileToRead.obstacle(file, FileKind.SETTINGS);
        if (obstacle.isPresent()) {
            setAside(obstacle.get());
            return otherwise;
        }
        try (var in = Files.newBufferedReader(file)) {
            var kept = new Properties();
            kept.load(in);
            return SettingsText.read(kept);
        } catch (SettingsText.UnreadableSettings e) {
            setAside(e.problem());
        } catch (CharacterCodingException | IllegalArgumentException e) {
            setAside(Problem.of("settings.noText"));
        } catch (IOException e) {
            setAside(WholeFile.reason(e));
        }
        return otherwise;
    }

    /**
     * Keeps the settings, whole or not at all. On any thread.
     *
     * @return whether they are kept
     */
    public synchronized boolean save(LabSettings settings) {
        if (inTheWay) return false;
        try {
            WholeFile.requireFolder(folder());
            WholeFile.write(file, SettingsText.write(settings).getBytes(StandardCharsets.UTF_8));
            return true;
        } catch (Complaint e) {
            tell(Problem.of("settings.notKept", e.getMessage()));
            return false;
        }
    }

    private void setAside(Object reason) {
        try {
            Path aside = BrokenFile.setAside(file);
            tell(Problem.of("settings.setAside", file.toString(), reason, aside.toString()));
        } catch (IOException e) {
            inTheWay = true;
            tell(
                    Problem.of(
                            "settings.inTheWay",
                            file.toString(),
                            reason,
                            file.getFileName().toString(),
                            WholeFile.reason(e)));
        }
    }

    private void tell(Problem wrong) {
        if (!told) problem.accept(wrong);
        told = true;
    }
}
