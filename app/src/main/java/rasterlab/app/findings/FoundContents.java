package rasterlab.app.findings;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Topic;

/**
 * The pages that lead to those of the topics: the contents, and all fronts at a glance. They link
 * the pages that this run wrote, and those of an earlier run with the same settings, which is told.
 *
 * @param folder where all pages are
 * @param settings as {@link PageOrigin} has them
 */
record FoundContents(Path folder, String settings, Texts texts, TopicNames called) {
    /** The finding about a topic. */
    record TopicFinding(boolean whole, boolean written, String sentence) {
        static TopicFinding none(String reason) {
            return new TopicFinding(false, false, reason);
        }
    }

    /** The page of contents. */
    static Path index(Path folder) {
        return folder.resolve("index.html");
    }

    /** The page of a topic. */
    static Path page(Path folder, Topic<?, ?, ?> topic) {
        return folder.resolve(topic.name() + ".html");
    }

    /**
     * @param again the command that repeats it all
     */
    void write(Map<Topic<?, ?, ?>, TopicFinding> found, String again) {
        var page = new FoundPage(texts.text("title"), texts);
        page.paragraph(texts.text("introduction"));
        page.link("course.html", texts.text("course"), texts.text("course.behind"));
        found.forEach((topic, one) -> addEntry(page, topic, one));
        page.heading(texts.text("again"));
        page.command(again);
        WholeFile.write(index(folder), page.html());
        writeCourse(found);
    }

    private void addEntry(FoundPage page, Topic<?, ?, ?> topic, TopicFinding one) {
        String name = FoundWords.capital(called.topic(topic.name()));
        String file = topic.name() + ".html";
        Optional<String> earlier = begun(topic);
        if (one.written()) page.entry(file, name, one.sentence());
        else if (earlier.isPresent())
            page.entry(
                    file, name, one.sentence() + " " + texts.text("earlier.same", earlier.get()));
        else if (Files.exists(page(folder, topic)))
            page.entry("", name, one.sentence() + " " + texts.text("earlier.other"));
        else page.entry("", name, one.sentence());
    }

    private void writeCourse(Map<Topic<?, ?, ?>, TopicFinding> found) {
        var page = new FoundPage(texts.text("course"), texts);
        page.link("index.html", texts.text("contents"), "");
        page.paragraph(texts.text("course.meaning"));
        page.begin("small gallery");
        found.forEach(
                (topic, one) -> {
                    String name = FoundWords.capital(called.topic(topic.name()));
                    Optional<String> earlier = begun(topic);
                    if (!one.written() && earlier.isEmpty()) return;
                    page.chart(
                            Findings.CHARTS + "/" + topic.name() + "-front",
                            one.written() ? name : texts.text("earlier.front", name, earlier.get()),
                            topic.name() + ".html");
                });
        page.end();
        WholeFile.write(folder.resolve("course.html"), page.html());
    }

    private Optional<String> begun(Topic<?, ?, ?> topic) {
        return PageOrigin.begun(page(folder, topic), settings);
    }
}
