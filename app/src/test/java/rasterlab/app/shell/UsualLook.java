package rasterlab.app.shell;

import com.formdev.flatlaf.FlatLaf;
import java.lang.reflect.Method;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javax.swing.ActionMap;
import javax.swing.InputMap;
import javax.swing.UIManager;
import rasterlab.app.shell.settings.LabTheme;

/**
 * The look that every class of tests begins with and leaves: light, in type of usual size, and
 * nothing said beside it that a window keeps for its parts. On the event thread.
 */
public final class UsualLook {
    private UsualLook() {}

    /** Makes it the look again, whatever was installed, and forgets what was put beside it. */
    public static void install() {
        for (String key : own().keySet()) UIManager.put(key, null);
        LabTheme.LIGHT.install();
    }

    /** The changes since, a line for each key; installs the look where there are any. */
    static Optional<String> restore() {
        Map<String, Object> found = now();
        if (Usual.LOOK.equals(found)) return Optional.empty();
        install();
        var keys = new TreeSet<>(found.keySet());
        keys.addAll(Usual.LOOK.keySet());
        return Optional.of(
                keys.stream()
                        .filter(key -> !Objects.equals(found.get(key), Usual.LOOK.get(key)))
                        .map(key -> key + ": " + found.get(key) + ", not " + Usual.LOOK.get(key))
                        .collect(Collectors.joining("\n")));
    }

    private static Map<String, Object> now() {
        Map<String, Object> look = own();
        look.put("look and feel", UIManager.getLookAndFeel().getClass().getSimpleName());
        Map<String, String> extra = FlatLaf.getGlobalExtraDefaults();
        look.put("colours", extra == null ? Map.of() : extra);
        return look;
    }

    /** The values that the program has put itself: {@code forEach} leaves out those of the look. */
    private static Map<String, Object> own() {
        var own = new TreeMap<String, Object>();
        UIManager.getDefaults()
                .forEach(
                        (key, value) -> {
                            if (!isKeptBySwing(value)) own.put(key.toString(), value);
                        });
        return own;
    }

    /** Whether it is made at its first use: classes of delegates, and keys of the text editor. */
    private static boolean isKeptBySwing(Object value) {
        return value instanceof Class
                || value instanceof Method
                || value instanceof ActionMap
                || value instanceof InputMap;
    }

    /** The look as it is after it has been installed. */
    private static final class Usual {
        private static final Map<String, Object> LOOK = installed();

        private static Map<String, Object> installed() {
            install();
            return now();
        }
    }
}
