package rasterlab.app.cli.study;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.cli.console.Console;
import rasterlab.app.found.FoundHazards;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.exercises.searching.Find;
import rasterlab.exercises.searching.HazardSearch;
import rasterlab.exercises.searching.SearchListener;

/** One search for an input on which a method fails, told while it goes on. */
final class SearchRun implements SearchListener {
    private static final int LONGEST = 3600;

    /** Characters of an input that is told while it is made simpler. */
    private static final int LONGEST_TOLD = 120;

    private final Console console;
    private final Texts texts;
    private final String topic;
    private final String method;
    private final int seed;
    private final Optional<Path> out;
    private final Optional<FoundHazards> kept;

    /**
     * @param out the file that the input is written to; null for none
     * @param keep whether the input is kept among the user's hazards
     */
    SearchRun(Console console, String topic, String method, int seed, Path out, boolean keep) {
        if (topic == null) throw Complaint.badInput("--search METHOD needs TOPIC");
        this.console = console;
        texts = console.language().texts();
        this.topic = TopicChoice.one(topic).name();
        this.method = method;
        this.seed = seed;
        this.out = Optional.ofNullable(out);
        kept = keep ? Optional.of(usual()) : Optional.empty();
    }

    /** The hazards that the window of this user shows. */
    private static FoundHazards usual() {
        Path settings = SettingsFile.usual(System.getenv(), System.getProperties());
        return FoundHazards.in(settings.toAbsolutePath().getParent());
    }

    /**
     * Searches at most so long, and says what was found.
     *
     * @param json whether as the scene file alone
     */
    int within(int seconds, boolean json) {
        if (seconds < 1 || seconds > LONGEST)
            throw Complaint.badInput("--seconds must be from 1 to " + LONGEST + ", got " + seconds);
        out.ifPresent(WholeFile::requireWritable);
        kept.ifPresent(FoundHazards::requireWritable);
        HazardSearch<?, ?, ?> search = search();
        Optional<Find> find = search.search(Duration.ofSeconds(seconds), () -> false);
        if (find.isEmpty()) {
            long tried = search.inputsTried();
            console.out()
                    .println(texts.text("search.nothing", topic, method, seconds, seed, tried));
            return ExitCode.DONE;
        }
        tell(find.get(), json);
        boolean promised =
                TopicChoice.one(topic).methods().stream()
                        .anyMatch(each -> each.name().equals(method) && each.promisesToBeRight());
        return promised ? ExitCode.FOUND_WRONG : ExitCode.DONE;
    }

    private HazardSearch<?, ?, ?> search() {
        try {
            return HazardSearch.of(topic, method, seed, this);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private void tell(Find find, boolean json) {
        String scene = find.scene().write();
        if (json) console.out().println(scene);
        else {
            console.out().println(findText("search.result", find));
            console.out().println(find.input());
        }
        out.ifPresent(
                file -> {
                    WholeFile.write(file, (scene + "\n").getBytes(StandardCharsets.UTF_8));
                    console.tell("wrote", file.toString());
                });
        kept.ifPresent(all -> console.tell("wrote", all.keep(find.scene()).toString()));
    }

    private String findText(String key, Find find) {
        String detail = find.verdict().detail();
        return texts.text(
                key,
                topic,
                method,
                new StudyWords(texts.language()).verdict(find.verdict().kind()),
                detail.isEmpty() ? "" : ": " + VerdictDetail.saidToTypist(texts.language(), detail),
                find.tried(),
                find.after().toMillis() / 1000.0);
    }

    private static String shortened(String input) {
        return input.length() <= LONGEST_TOLD ? input : input.substring(0, LONGEST_TOLD) + "…";
    }

    @Override
    public void tried(long inputs) {
        console.err().println(texts.text("search.tried", inputs));
    }

    @Override
    public void found(Find find) {
        console.err().println(findText("search.found", find));
    }

    @Override
    public void simpler(Find find) {
        console.err().println(texts.text("search.simpler", shortened(find.input())));
    }
}
