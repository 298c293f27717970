package rasterlab.app.cli.study;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.language.Texts;
import rasterlab.app.study.StudyCost;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Ranking;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.PaceComparison;
import rasterlab.engine.study.measuring.RoundPlan;

/** The order of a study's methods at each workload, as far as it can be told, as lines of text. */
final class RankingText {
    private static final long CERTAIN = Math.round(100 * MedianInterval.CONFIDENCE);

    private final Study study;
    private final StudyCost cost;
    private final Texts texts;
    private final StudyWords words;

    RankingText(Study study, ReportLanguage language) {
        this(study, StudyCost.TIME, language);
    }

    /**
     * @param study with such costs
     */
    RankingText(Study study, StudyCost cost, ReportLanguage language) {
        this.study = study;
        this.cost = cost;
        texts = language.texts();
        words = new StudyWords(language.inWindow());
    }

    List<String> lines() {
        var lines = new ArrayList<String>();
        List<Ranking> rankings =
                Ranking.all(study).stream().filter(one -> one.places().size() > 1).toList();
        if (!study.isWhole() && !study.isTimed()) add(lines, texts.text("rank.untimed"));
        if (rankings.isEmpty()) return lines;
        lines.add("");
        boolean timed = cost == StudyCost.TIME;
        String alike = String.valueOf(Math.round(100 * (PaceComparison.LEAST_GAP - 1)));
        add(
                lines,
                timed
                        ? texts.text("rank.title", alike)
                        : texts.text("rank." + cost.code(), words.item(study)));
        for (Ranking ranking : rankings)
            add(
                    lines,
                    ranking.workload() + ": " + (timed ? rankingText(ranking) : counted(ranking)));
        if (timed && rankings.stream().anyMatch(one -> one.rounds() < RoundPlan.LEAST))
            add(lines, texts.text("rank.few", RoundPlan.LEAST, CERTAIN));
        if (timed) addOpen(lines, rankings);
        study.circumstances().ifPresent(how -> addNoise(lines, how));
        return lines;
    }

    private static void add(List<String> lines, String text) {
        lines.addAll(Wrapping.lines(text, StudyTable.WIDTH, String::length));
    }

    private String rankingText(Ranking ranking) {
        var said = new StringBuilder(words.called(ranking.places().get(0).method()));
        for (int next = 1; next < ranking.places().size(); next++)
            said.append(sign(ranking.toNext(next - 1).order()))
                    .append(words.called(ranking.places().get(next).method()));
        return said.toString();
    }

    private static String sign(PaceComparison.Order order) {
        return switch (order) {
            case FASTER, SLOWER -> " < ";
            case ALIKE -> " ~ ";
            case OPEN -> " ? ";
        };
    }

    private String counted(Ranking ranking) {
        var said = new StringBuilder();
        double before = 0;
        for (var place : ranking.places()) {
            double count = place.cost().medianNanos();
            if (said.length() > 0) said.append(count == before ? " = " : " < ");
            before = count;
            said.append(words.called(place.method()))
                    .append(' ')
                    .append(String.format(texts.locale(), "%.4g", count));
        }
        return said.toString();
    }

    private void addOpen(List<String> lines, List<Ranking> rankings) {
        List<Ranking> open = rankings.stream().filter(one -> one.open() > 0).toList();
        for (Ranking ranking : open)
            ranking.more()
                    .ifPresent(
                            more ->
                                    add(
                                            lines,
                                            texts.text(
                                                    "rank.more",
                                                    more,
                                                    ranking.rounds() + more,
                                                    ranking.open(),
                                                    ranking.workload())));
        String hopeless =
                open.stream()
                        .filter(one -> one.more().isEmpty())
                        .map(Ranking::workload)
                        .collect(Collectors.joining(", "));
        if (!hopeless.isEmpty()) add(lines, texts.text("rank.hopeless", hopeless));
    }

    private void addNoise(List<String> lines, StudyConditions how) {
        add(
                lines,
                texts.text(
                        study.isBusy() ? "rank.busy" : "rank.noise",
                        String.format(texts.locale(), "%.1f", 100 * (study.noise() - 1)),
                        load(how.loadBefore()),
                        load(how.loadAfter())));
        if (!how.whole()) add(lines, texts.text("rank.cut"));
    }

    private String load(double load) {
        return load < 0 ? "–" : String.format(texts.locale(), "%.1f", load);
    }
}
