package rasterlab.app.cli.study;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Texts;
import rasterlab.app.light.MachBandsChart;
import rasterlab.app.line.figure.BrightnessChart;
import rasterlab.app.perspective.PerspectiveChart;
import rasterlab.app.perspective.Stretch;
import rasterlab.app.precision.DepthPrecisionChart;
import rasterlab.app.visibility.GrowthChart;
import rasterlab.engine.signmap.SignMap;
import rasterlab.engine.transform.PerspectiveAmount;
import rasterlab.engine.visibility.depth.DepthPrecision;
import rasterlab.engine.visibility.hidden.Growth;

/** The tables that {@code ./lab chart} prints, one for each chart, in one language. */
final class ChartTables {
    private final Texts texts;

    ChartTables(Texts texts) {
        this.texts = texts;
    }

    TextTable brightness(BrightnessChart chart) {
        List<Integer> angles = List.of(0, 30, 45, 90);
        var heads = new ArrayList<>(List.of(texts.text("chart.method")));
        for (int angle : angles) heads.add(texts.text("chart.degrees", angle));
        var table = new TextTable(heads);
        for (String method : chart.methods())
            table.add(
                    Stream.concat(
                                    Stream.of(method),
                                    angles.stream()
                                            .map(degrees -> chart.light(method).get(degrees))
                                            .map(this::lightOrNone))
                            .toList());
        return table;
    }

    private String lightOrNone(double light) {
        return Double.isNaN(light) ? "-" : thousandths(light);
    }

    TextTable signs(List<SignMap> maps) {
        var table =
                new TextTable(
                        texts.text("chart.predicate"),
                        texts.text("chart.method"),
                        texts.text("chart.numbers"),
                        texts.text("chart.wrong"),
                        texts.text("chart.more"),
                        texts.text("chart.less"),
                        texts.text("chart.unanswered"));
        for (SignMap map : maps)
            table.add(
                    List.of(
                            map.subject(),
                            map.method(),
                            map.spacing().code(),
                            percent(map),
                            "" + map.extra(),
                            "" + map.missing(),
                            "" + map.unanswered()));
        return table;
    }

    TextTable perspective() {
        var table = new TextTable("z'/dz'", "gamma", texts.text("chart.stretch"));
        for (PerspectiveAmount.PerspectiveSample sample : PerspectiveChart.table())
            table.add(
                    List.of(
                            String.format(texts.locale(), "%.1f", sample.distance()),
                            String.format(texts.locale(), "%.3f", sample.gamma()),
                            texts.text("stretch." + Stretch.of(sample.distance()).code())));
        return table;
    }

    TextTable depthPrecision() {
        var table =
                new TextTable(
                        texts.text("chart.format"),
                        "far/near",
                        texts.text("chart.measured"),
                        texts.text("chart.predicted"));
        for (DepthPrecision.PrecisionSample sample : DepthPrecisionChart.table())
            table.add(
                    List.of(
                            sample.format(),
                            String.format(texts.locale(), "%.0e", sample.ratio()),
                            String.format(texts.locale(), "%.3e", sample.measured()),
                            String.format(texts.locale(), "%.3e", sample.predicted())));
        return table;
    }

    TextTable machBands() {
        var table =
                new TextTable(
                        texts.text("chart.shading"),
                        texts.text("chart.step"),
                        texts.text("chart.bend"));
        MachBandsChart.profiles()
                .forEach(
                        (shading, profile) ->
                                table.add(
                                        List.of(
                                                shading,
                                                thousandths(profile.largestStep()),
                                                thousandths(profile.largestKink()))));
        return table;
    }

    /** The share of wrong points, which is 0.0 only where there is none. */
    private String percent(SignMap map) {
        boolean least = map.extra() + map.missing() > 0 && map.share() < 0.0005;
        return (least ? "<" : "")
                + String.format(texts.locale(), "%.1f %%", least ? 0.1 : 100 * map.share());
    }

    private String thousandths(double share) {
        return String.format(texts.locale(), "%.3f", share);
    }

    /**
     * The nanoseconds that a curve costs in all, with a star where the planner takes the method.
     */
    TextTable segments(List<CurveSegments.SegmentRow> rows) {
        var heads =
                new ArrayList<>(
                        List.of(
                                texts.text("chart.flatness"),
                                texts.text("chart.method"),
                                texts.text("chart.segments"),
                                texts.text("chart.error")));
        for (long times : CurveSegments.TIMES) heads.add(texts.text("chart.drawn", times));
        var table = new TextTable(heads);
        for (CurveSegments.SegmentRow row : rows) {
            var cells =
                    new ArrayList<>(
                            List.of(
                                    String.format(texts.locale(), "%.4g", row.flatness()),
                                    row.method(),
                                    String.format(texts.locale(), "%.1f", row.segments()),
                                    thousandths(row.error())));
            for (int i = 0; i < CurveSegments.TIMES.size(); i++)
                cells.add(row.nanos().isEmpty() ? "-" : price(row, i));
            table.add(cells);
        }
        return table;
    }

    private String price(CurveSegments.SegmentRow row, int place) {
        String nanos = String.format(texts.locale(), "%.0f", row.nanos().get(place));
        return row.chosen().get(place) ? "*" + nanos : nanos;
    }

    TextTable growth(GrowthChart growth) {
        var table =
                new TextTable(
                        texts.text("chart.method"),
                        texts.text("chart.area"),
                        texts.text("chart.size"),
                        "n");
        for (String method : growth.methods())
            table.add(
                    Stream.concat(
                                    Stream.of(method),
                                    Stream.of(Growth.Axis.values())
                                            .map(axis -> growth.growth(method, axis).exponent())
                                            .map(p -> String.format(texts.locale(), "%.2f", p)))
                            .toList());
        return table;
    }
}
