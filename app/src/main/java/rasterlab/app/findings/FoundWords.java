package rasterlab.app.findings;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.Cell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Ranking;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.PaceComparison;

/**
 * Says in a few sentences what the numbers of one topic show: who wins where, what accuracy costs,
 * and where it fails first. Nothing is said of times that are not told apart but that they are not.
 */
final class FoundWords {
    private final Topic<?, ?, ?> topic;
    private final Study study;
    private final HazardMatrix hazards;
    private final Texts texts;
    private final StudyWords words;
    private final TopicNames called;
    private final ParetoFront front;

    FoundWords(Topic<?, ?, ?> topic, Study study, HazardMatrix hazards, Language language) {
        this.topic = topic;
        this.study = study;
        this.hazards = hazards;
        texts = Texts.of("findings", language);
        words = new StudyWords(language);
        called = TopicNames.in(language);
        front = ParetoFront.of(study, ParetoFront.telling(study));
    }

    List<String> sentences() {
        var said = new ArrayList<String>();
        said.add(whoWins());
        price().ifPresent(said::add);
        firstFailure().ifPresent(said::add);
        hardest().ifPresent(said::add);
        return said;
    }

    /** A name as it stands at the beginning of a line. */
    static String capital(String name) {
        int first = name.isEmpty() ? 0 : Character.charCount(name.codePointAt(0));
        return name.substring(0, first).toUpperCase(Locale.ROOT) + name.substring(first);
    }

    /** The quickest exact method of each workload, as far as it is told apart from the next. */
    private String whoWins() {
        var winners = new LinkedHashMap<String, List<String>>();
        var open = new ArrayList<String>();
        List<Ranking> rankings = Ranking.all(study);
        for (Ranking ranking : rankings) {
            List<Integer> exact =
                    IntStream.range(0, ranking.places().size())
                            .filter(i -> ParetoFront.error(ranking.places().get(i)) == 0)
                            .boxed()
                            .toList();
            if (exact.isEmpty()) continue;
            String load = words.workload(topic.name(), ranking.workload());
            String first = words.called(ranking.places().get(exact.get(0)).method());
            boolean told =
                    exact.size() == 1
                            || ranking.compared(exact.get(0), exact.get(1)).order()
                                    == PaceComparison.Order.FASTER;
            if (told) winners.computeIfAbsent(first, name -> new ArrayList<>()).add(load);
            else open.add(load);
        }
        if (winners.isEmpty() && open.isEmpty()) return texts.text("wins.none");
        if (open.size() == rankings.size()) return texts.text("wins.openAll");
        var said = new ArrayList<String>();
        if (!winners.isEmpty())
            said.add(
                    texts.text(
                            "wins",
                            winners.entrySet().stream()
                                    .map(
                                            one ->
                                                    texts.text(
                                                            "wins.at",
                                                            one.getKey(),
                                                            String.join("; ", one.getValue())))
                                    .collect(Collectors.joining("; "))));
        if (!open.isEmpty())
            said.add(withOneStop(texts.text("wins.open", String.join("; ", open))));
        return String.join(" ", said);
    }

    /** The sentence with one full stop where it ends in an abbreviation. */
    private static String withOneStop(String sentence) {
        return sentence.replaceFirst("\\.\\.$", ".");
    }

    /** The price of the quickest exact method beside the quickest of all. */
    private Optional<String> price() {
        List<Measurement> places = front.ranking().places();
        if (places.isEmpty()) return Optional.empty();
        Optional<Integer> exact =
                IntStream.range(0, places.size())
                        .filter(i -> ParetoFront.error(places.get(i)) == 0)
                        .boxed()
                        .findFirst();
        String load = words.workload(topic.name(), front.ranking().workload());
        if (exact.isEmpty()) return Optional.of(texts.text("price.noExact", load));
        PaceComparison pair = front.ranking().compared(exact.get(), 0);
        if (exact.get() == 0) return Optional.of(texts.text("price.none", load, name(places, 0)));
        if (pair.order() != PaceComparison.Order.SLOWER)
            return Optional.of(
                    texts.text("price.open", load, name(places, exact.get()), name(places, 0)));
        double error = ParetoFront.error(places.get(0));
        return Optional.of(
                texts.text(
                        Double.isFinite(error) ? "price" : "price.wrong",
                        load,
                        number(pair.ratio()),
                        number(pair.low()),
                        number(pair.high()),
                        name(places, exact.get()),
                        name(places, 0),
                        Double.isFinite(error) ? words.shortNumber(error) : "∞",
                        words.errorUnit(study)));
    }

    private String name(List<Measurement> places, int place) {
        return words.called(places.get(place).method());
    }

    private String number(double value) {
        return String.format(texts.locale(), "%.2f", value);
    }

    /** The methods that fail at the first workload at which any does. */
    private Optional<String> firstFailure() {
        for (Ranking ranking : Ranking.all(study)) {
            List<Measurement> failing =
                    study.measurements().stream()
                            .filter(one -> one.workload().equals(ranking.workload()))
                            .filter(one -> one.kind() != Verdict.Kind.EXACT)
                            .sorted(
                                    Comparator.comparing(
                                            (Measurement one) -> one.kind(),
                                            Comparator.reverseOrder()))
                            .toList();
            if (failing.isEmpty()) continue;
            String said =
                    failing.stream()
                            .map(
                                    one ->
                                            words.called(one.method())
                                                    + " ("
                                                    + words.verdict(one.kind())
                                                    + ")")
                            .collect(Collectors.joining(", "));
            return Optional.of(
                    texts.text("fails", words.workload(topic.name(), ranking.workload()), said));
        }
        return Optional.of(texts.text("fails.none"));
    }

    /** The hazard on which most methods are not exact. */
    private Optional<String> hardest() {
        return topic.hazards().stream()
                .max(Comparator.comparingLong(this::failures))
                .filter(hazard -> failures(hazard) > 0)
                .map(
                        hazard ->
                                texts.text(
                                        "hardest",
                                        called.hazard(topic, hazard),
                                        failures(hazard),
                                        hazards.methods().size()));
    }

    private long failures(Hazard<?> hazard) {
        return hazards.cells().stream()
                .filter(cell -> cell.hazard().equals(hazard.name()))
                .map(Cell::verdict)
                .filter(verdict -> verdict.kind() != Verdict.Kind.EXACT)
                .count();
    }
}
