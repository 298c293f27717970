package rasterlab.app.findings;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Ranking;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.PaceComparison;
import rasterlab.engine.study.measuring.PaceComparison.Order;

/**
 * Says in a few sentences what the numbers of one topic show: who wins where, what accuracy costs,
 * and where it fails first. Nothing is said of times that are not told apart but that they are not.
 */
final class FoundWords {
    /** The answers that are mistakes. */
    private static final Set<Verdict.Kind> FAILURES =
            EnumSet.of(Verdict.Kind.WRONG, Verdict.Kind.ENDLESS, Verdict.Kind.CRASHED);

    private static final Set<Verdict.Kind> REFUSALS = EnumSet.of(Verdict.Kind.REFUSED);
    private static final Set<Verdict.Kind> DEGRADED = EnumSet.of(Verdict.Kind.DEGRADED);

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
        said.add(
                Stream.of(
                                Optional.of(
                                        first("fails", FAILURES).orElse(texts.text("fails.none"))),
                                first("refuses", REFUSALS),
                                first("degrades", DEGRADED))
                        .flatMap(Optional::stream)
                        .collect(Collectors.joining(" ")));
        hardest().ifPresent(said::add);
        return said;
    }

    /** When and where it was measured, and how far its times can be trusted. */
    String measured(StudyConditions how) {
        return texts.text(
                study.isBusy() ? "how.busy" : "how.measured",
                Findings.begun(how),
                how.machine().described(),
                String.format(texts.locale(), "%.1f", Math.max(0, how.loadBefore())),
                study.isBusy()
                        ? (Object) Math.round(study.noise())
                        : String.format(texts.locale(), "%.1f", 100 * (study.noise() - 1)),
                how.settings().seed());
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
            List<Integer> exact = places(ranking, true);
            if (exact.isEmpty()) continue;
            String load = words.workload(topic.name(), ranking.workload());
            String first = name(ranking, exact.get(0));
            boolean told =
                    exact.stream()
                            .skip(1)
                            .allMatch(
                                    other ->
                                            ranking.compared(exact.get(0), other).order()
                                                    == Order.FASTER);
            if (told) winners.computeIfAbsent(first, name -> new ArrayList<>()).add(load);
            else open.add(load);
        }
        if (winners.isEmpty() && open.isEmpty()) return texts.text("wins.none");
        if (open.size() == rankings.size()) return texts.text("wins.openAll");
        if (winners.size() == 1 && open.isEmpty() && rankings.size() > 1) {
            Map.Entry<String, List<String>> only = winners.entrySet().iterator().next();
            if (only.getValue().size() == rankings.size())
                return texts.text("wins.all", only.getKey());
        }
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

    /**
     * The price of the quickest exact method beside the quickest that is not exact, where every
     * exact one is told to be slower than that.
     */
    private Optional<String> price() {
        Ranking ranking = front.ranking();
        if (ranking.places().isEmpty()) return Optional.empty();
        List<Integer> exact = places(ranking, true);
        List<Integer> others = places(ranking, false);
        String load = words.workload(topic.name(), ranking.workload());
        if (exact.isEmpty()) return Optional.of(texts.text("price.noExact", load));
        if (others.isEmpty()) return Optional.of(texts.text("price.allExact", load));
        int best = exact.get(0);
        int quick = others.get(0);
        Optional<Integer> rival =
                others.stream().filter(other -> isMaybeSlower(ranking, best, other)).findFirst();
        if (rival.isEmpty())
            return Optional.of(texts.text("price.none", load, name(ranking, best)));
        Optional<Integer> open =
                exact.stream()
                        .filter(one -> ranking.compared(one, quick).order() != Order.SLOWER)
                        .findFirst();
        return Optional.of(
                open.isEmpty()
                        ? price(load, ranking, best, quick)
                        : texts.text(
                                "price.open",
                                load,
                                name(ranking, open.get()),
                                name(ranking, open.get() == best ? rival.get() : quick)));
    }

    private static boolean isMaybeSlower(Ranking ranking, int place, int other) {
        Order order = ranking.compared(place, other).order();
        return order == Order.SLOWER || order == Order.OPEN;
    }

    private String price(String load, Ranking ranking, int exact, int quick) {
        PaceComparison pair = ranking.compared(exact, quick);
        double error = ParetoFront.error(ranking.places().get(quick));
        return texts.text(
                Double.isFinite(error) ? "price" : "price.wrong",
                load,
                number(pair.ratio()),
                number(pair.low()),
                number(pair.high()),
                name(ranking, exact),
                name(ranking, quick),
                Double.isFinite(error) ? words.shortNumber(error) : "∞",
                words.errorUnit(study));
    }

    /** The places of the exact methods, or of the others. */
    private static List<Integer> places(Ranking ranking, boolean exact) {
        return IntStream.range(0, ranking.places().size())
                .filter(i -> ParetoFront.error(ranking.places().get(i)) == 0 == exact)
                .boxed()
                .toList();
    }

    private String name(Ranking ranking, int place) {
        return words.called(ranking.places().get(place).method());
    }

    private String number(double value) {
        return String.format(texts.locale(), "%.2f", value);
    }

    /** The methods with such answers at the first workload that has any; empty where none has. */
    private Optional<String> first(String key, Set<Verdict.Kind> kinds) {
        for (Ranking ranking : Ranking.all(study)) {
            String said =
                    study.measurements().stream()
                            .filter(one -> one.workload().equals(ranking.workload()))
                            .filter(one -> kinds.contains(one.kind()))
                            .sorted(Comparator.comparing(Measurement::kind).reversed())
                            .map(one -> named(one, kinds))
                            .collect(Collectors.joining(", "));
            if (!said.isEmpty())
                return Optional.of(
                        texts.text(key, words.workload(topic.name(), ranking.workload()), said));
        }
        return Optional.empty();
    }

    /** A method, with its answer where it could be one of several. */
    private String named(Measurement one, Set<Verdict.Kind> kinds) {
        String method = words.called(one.method());
        return kinds.size() == 1 ? method : method + " (" + words.verdict(one.kind()) + ")";
    }

    /** The hazard on which most methods fail; where none does, the one that most refuse. */
    private Optional<String> hardest() {
        if (topic.hazards().isEmpty()) return Optional.empty();
        Hazard<?> worst = most(FAILURES);
        if (count(worst, FAILURES) > 0) return Optional.of(hardest(worst));
        Hazard<?> refused = most(REFUSALS);
        String none = texts.text("hardest.none");
        return Optional.of(
                count(refused, REFUSALS) == 0
                        ? none
                        : none + " " + counted("hardest.refused", refused, REFUSALS));
    }

    private String hardest(Hazard<?> hazard) {
        var said = new ArrayList<String>(List.of(counted("hardest", hazard, FAILURES)));
        long refused = count(hazard, REFUSALS);
        long degraded = count(hazard, DEGRADED);
        if (refused > 0) said.add(texts.text("hardest.refuse", refused));
        if (degraded > 0) said.add(texts.text("hardest.degrade", degraded));
        return String.join("; ", said) + ".";
    }

    private String counted(String key, Hazard<?> hazard, Set<Verdict.Kind> kinds) {
        return texts.text(
                key, called.hazard(topic, hazard), count(hazard, kinds), hazards.methods().size());
    }

    private Hazard<?> most(Set<Verdict.Kind> kinds) {
        return topic.hazards().stream()
                .max(Comparator.comparingLong(hazard -> count(hazard, kinds)))
                .orElseThrow();
    }

    private long count(Hazard<?> hazard, Set<Verdict.Kind> kinds) {
        return hazards.cells().stream()
                .filter(cell -> cell.hazard().equals(hazard.name()))
                .filter(cell -> kinds.contains(cell.verdict().kind()))
                .count();
    }
}
