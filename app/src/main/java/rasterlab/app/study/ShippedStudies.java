package rasterlab.app.study;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.measuring.Machine;
import rasterlab.exercises.json.NotJson;

/**
 * The results that come with the program, so that the tab shows a chart before anything was
 * measured: a study of each topic, with the machine that it was measured on.
 *
 * <p>{@code ./lab study --all --ship DIR} writes them anew; DIR is their folder among the resources
 * of this package.
 */
public final class ShippedStudies {
    /**
     * The most rounds of a measurement: their interval holds the median as often as that of all.
     */
    private static final int MOST_ROUNDS = 15;

    private static final int DIGITS = 4;
    private static final int DIGITS_OF_ERRORS = 3;

    private ShippedStudies() {}

    /**
     * The result that ships for that topic, of the methods and workloads that it still has; empty
     * where there is none.
     */
    static Optional<Study> of(Topic<?, ?, ?> topic) {
        try (InputStream in =
                ShippedStudies.class.getResourceAsStream("shipped/" + file(topic.name()))) {
            if (in == null) return Optional.empty();
            String json = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            return Optional.of(StudyReading.of(json, topic))
                    .filter(study -> !study.measurements().isEmpty());
        } catch (NotJson | IllegalArgumentException e) {
            throw new AssertionError("shipped result of " + topic.name() + " is broken", e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Writes a study as it ships.
     *
     * @param folder that is there
     * @return the file
     * @throws rasterlab.app.outcome.Complaint if it cannot be written
     */
    public static Path write(Study study, Path folder) {
        Path file = folder.resolve(file(study.topic()));
        WholeFile.write(file, StudyJson.brief(brief(study)));
        return file;
    }

    private static String file(String topic) {
        return topic + ".json";
    }

    /** The study with no more digits and rounds than its charts need. */
    static Study brief(Study study) {
        return new Study(
                study.topic(),
                study.item(),
                study.errorUnit(),
                study.measurements().stream().map(ShippedStudies::brief).toList(),
                study.circumstances().map(ShippedStudies::brief));
    }

    private static StudyConditions brief(StudyConditions how) {
        Machine where = how.machine();
        Map<String, List<Double>> fixed =
                how.fixed().entrySet().stream()
                        .collect(Collectors.toMap(Map.Entry::getKey, one -> few(one.getValue())));
        return new StudyConditions(
                how.settings(),
                how.begun().truncatedTo(ChronoUnit.SECONDS),
                new Machine(
                        where.system().split(" ")[0],
                        where.processor(),
                        where.cores(),
                        where.heapBytes(),
                        where.java()),
                rounded(how.loadBefore(), DIGITS_OF_ERRORS),
                rounded(how.loadAfter(), DIGITS_OF_ERRORS),
                fixed,
                how.whole());
    }

    private static Measurement brief(Measurement one) {
        Deviation error = one.error();
        return new Measurement(
                one.method(),
                one.workload(),
                one.size(),
                Cost.of(few(one.cost().rounds()), one.cost().counts()),
                new Deviation(
                        rounded(error.worst(), DIGITS),
                        error.missing(),
                        error.extra(),
                        error.of(),
                        ""),
                one.kind(),
                one.detail(),
                one.errors().stream().map(each -> rounded(each, DIGITS_OF_ERRORS)).toList());
    }

    /** Takes as many rounds as ship, spread evenly over all. */
    private static List<Double> few(List<Double> rounds) {
        int shown = Math.min(MOST_ROUNDS, rounds.size());
        return IntStream.range(0, shown)
                .mapToObj(i -> rounded(rounds.get(i * rounds.size() / shown), DIGITS))
                .toList();
    }

    private static double rounded(double value, int digits) {
        return Double.isFinite(value)
                ? new BigDecimal(value).round(new MathContext(digits)).doubleValue()
                : value;
    }
}
