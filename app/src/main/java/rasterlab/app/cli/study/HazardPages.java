package rasterlab.app.cli.study;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import rasterlab.app.cli.console.Console;
import rasterlab.app.hazard.HazardPage;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;

/** Pages of hazards on disk: one file, or a folder with one for each topic. */
record HazardPages(Console console, Path place) {
    private static final String EXTENSION = ".html";

    int write(List<? extends Topic<?, ?, ?>> topics) {
        boolean one = topics.size() == 1 && place.toString().endsWith(EXTENSION);
        if (one) {
            Path folder = place.toAbsolutePath().getParent();
            if (folder != null) WholeFile.requireFolder(folder);
            WholeFile.requireWritable(place);
            return code(write(topics.get(0), place));
        }
        WholeFile.requireFolder(place);
        boolean asRecorded = true;
        for (Topic<?, ?, ?> topic : topics)
            asRecorded &= write(topic, place.resolve(topic.name() + EXTENSION));
        write(
                place.resolve("index" + EXTENSION),
                HazardPage.contents(List.copyOf(topics), language()));
        return code(asRecorded);
    }

    private static int code(boolean asRecorded) {
        return asRecorded ? ExitCode.DONE : ExitCode.FOUND_WRONG;
    }

    /** Whether every verdict is the recorded one. */
    private boolean write(Topic<?, ?, ?> topic, Path file) {
        HazardPage.HazardDocument page = HazardPage.of(topic, HazardTrial.WALL_LIMIT, language());
        write(file, page.html());
        return page.matrix().asRecorded();
    }

    private void write(Path file, String html) {
        WholeFile.write(file, html.getBytes(StandardCharsets.UTF_8));
        console.tell("wrote", file.toString());
    }

    private Language language() {
        return console.language().inWindow();
    }
}
