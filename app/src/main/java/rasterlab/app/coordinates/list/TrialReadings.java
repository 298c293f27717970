package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Describes a trial and its outcome in words and numbers of one language. */
final class TrialReadings {
    private static final String NONE = "—";

    private static final int DECIMALS = 4;

    /** The most points whose numbers are written. */
    private static final int MOST = 8;

    private final ListLabModel model;
    private final Texts texts;
    private final Texts verdicts;

    TrialReadings(ListLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        verdicts = Texts.of("study", texts.language());
    }

    /** The result of the chosen method; empty until it is known. */
    /** The result of the chosen method for the hazard; empty until it is found. */
    Optional<TrialScene> known() {
        return model.trial()
                .filter(scene -> model.choice().trial().equals(Optional.of(scene.trial())));
    }

    /** The special thing about the hazard. */
    String hazard() {
        return model.choice()
                .trial()
                .map(
                        trial -> {
                            Hazard<?> hazard = model.trials().hazard(trial);
                            return GivenInput.is(hazard.name())
                                    ? GivenInput.sentence(texts.language())
                                    : TopicTexts.of(trial.topic(), texts.language()).hazard(hazard);
                        })
                .orElse("");
    }

    String verdict() {
        return known().map(scene -> verdictText(scene.verdict())).orElse(NONE);
    }

    private String verdictText(Verdict verdict) {
        return verdicts.text("verdict." + verdict.kind().code());
    }

    /** The largest error, in the topic's unit. */
    String error() {
        return known().filter(scene -> scene.made().isPresent())
                .map(scene -> Shown.number(scene.verdict().deviation().worst(), 3, texts.locale()))
                .orElse(NONE);
    }

    /** The unit of the error. */
    String unit() {
        return model.choice().trial().map(trial -> unit(trial.topic())).orElse("");
    }

    /** A topic whose unit no other has says it among its own words. */
    private String unit(String topic) {
        String english = model.trials().kind(topic).topic().errorUnit();
        String shared = verdicts.textOr("unit." + english.replaceAll("[^a-z]+", "-"), english);
        return Texts.ofTopic(topic, texts.language()).textOr("unit", shared);
    }

    String off() {
        return known().filter(scene -> scene.made().isPresent())
                .map(scene -> texts.text("trial.off.of", scene.off(), scene.size()))
                .orElse(NONE);
    }

    /** A sentence over the picture, "" for none. */
    String note() {
        Optional<TrialScene> tried = model.trial();
        if (tried.isEmpty() || model.step() == 0 && model.last() > 0) return "";
        boolean onTheWay = model.shownTrial().isEmpty();
        return note(
                tried.get(),
                onTheWay
                        ? List.of(
                                ShownDifference.of(
                                        ShownDifference.ShownDifferenceKind.OTHER_METHOD))
                        : tried.get().differences());
    }

    /** The first difference is in the table's numbers, a refusal only here. */
    private String note(TrialScene scene, List<ShownDifference> differences) {
        Verdict verdict = scene.verdict();
        if (differences.isEmpty() && verdict.kind() == Verdict.Kind.EXACT) return "";
        String detail = scene.made().isPresent() ? "" : verdict.detail();
        return new HazardNote(
                        scene.trial().hazard(),
                        scene.trial().method(),
                        new Verdict(verdict.kind(), verdict.deviation(), detail),
                        differences)
                .in(texts.language());
    }

    List<String> headings() {
        var headings = new ArrayList<>(List.of("", "x", "y", "z"));
        if (known().flatMap(scene -> scene.exact().h()).isPresent()) headings.add("H");
        return headings;
    }

    /** Each point as it is given, where it belongs, where the method has it and how far off. */
    List<List<String>> rows() {
        return known().map(this::rows).orElse(List.of());
    }

    private List<List<String>> rows(TrialScene scene) {
        var rows = new ArrayList<List<String>>();
        List<Integer> points = points(scene);
        for (int point : points) {
            var given = new TrialScene.TrialPoints(scene.given(), Optional.empty());
            rows.add(coordinates(texts.text("row.point", point + 1), given, point));
            rows.add(coordinates(texts.text("row.exact"), scene.exact(), point));
            scene.made()
                    .ifPresent(
                            made -> {
                                rows.add(coordinates(texts.text("row.made"), made, point));
                                rows.add(errors(off(made, scene.exact()), point));
                            });
        }
        int more = scene.size() - points.size();
        if (more > 0) rows.add(List.of(texts.text("row.more", more)));
        return rows;
    }

    /** The points to list: those that are off first, as many as can be written. */
    private static List<Integer> points(TrialScene scene) {
        return IntStream.range(0, scene.size())
                .boxed()
                .sorted((a, b) -> Boolean.compare(isRight(scene, a), isRight(scene, b)))
                .limit(MOST)
                .sorted()
                .toList();
    }

    private static boolean isRight(TrialScene scene, int point) {
        return scene.fates().isEmpty() || scene.fates().get(point) == TrialScene.Fate.RIGHT;
    }

    private static TrialScene.TrialPoints off(
            TrialScene.TrialPoints made, TrialScene.TrialPoints exact) {
        return new TrialScene.TrialPoints(
                minus(made.points(), exact.points()),
                made.h().map(all -> minus(all, exact.h().orElseThrow())));
    }

    private static double[] minus(double[] a, double[] b) {
        return IntStream.range(0, a.length).mapToDouble(i -> a[i] - b[i]).toArray();
    }

    /** A number that is only rounding beside the point's largest coordinate reads as 0. */
    private List<String> coordinates(String name, TrialScene.TrialPoints placed, int point) {
        double[] xyz = placed.of(point);
        double largest = Arrays.stream(xyz).map(Math::abs).max().orElse(0);
        return row(name, xyz, placed.h(), point, value -> coordinate(value, largest));
    }

    private List<String> errors(TrialScene.TrialPoints off, int point) {
        return row(texts.text("row.off"), off.of(point), off.h(), point, this::number);
    }

    private List<String> row(
            String name,
            double[] xyz,
            Optional<double[]> h,
            int point,
            DoubleFunction<String> written) {
        var row = new ArrayList<String>();
        row.add(name);
        for (double each : xyz) row.add(written.apply(each));
        h.ifPresent(all -> row.add(number(all[point])));
        return row;
    }

    private String coordinate(double value, double largest) {
        return Double.isFinite(value)
                ? Shown.coordinate(value, largest, DECIMALS, texts.locale())
                : NONE;
    }

    private String number(double value) {
        return Double.isFinite(value) ? Shown.number(value, DECIMALS, texts.locale()) : NONE;
    }
}
