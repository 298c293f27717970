package rasterlab.app.cli;

import java.util.Map;
import java.util.function.Predicate;
import rasterlab.engine.scene.Scene;

/**
 * A scene to render, with what its file says about how.
 *
 * @param scene seen first as the file says
 * @param said options of {@code ./lab render} and their values; empty for a scene that the lab has
 * @param onCommandLine whether an option was given there
 */
record ShownScene(Scene scene, Map<String, String> said, Predicate<String> onCommandLine) {
    /**
     * What counts for an option: the command line before the file, the file before the default.
     *
     * @param value from the command line, or else the default
     */
    String option(String name, String value) {
        return onCommandLine.test(name) ? value : said.getOrDefault(name, value);
    }
}
