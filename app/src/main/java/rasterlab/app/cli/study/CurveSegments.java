package rasterlab.app.cli.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.study.StudyCost;
import rasterlab.app.study.front.FrontChart;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.spline.plan.CurvePlan;
import rasterlab.engine.spline.plan.CurvePrices;
import rasterlab.engine.study.ForwardingTopic;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Workload;

/**
 * The segments that methods make of the same curves against their error, and which of them the
 * planner takes, by how often the polylines are drawn. Nothing of it is timed.
 */
final class CurveSegments {
    /** How often polylines are drawn. */
    static final List<Long> TIMES = List.of(1L, 10L, 100L, 1000L);

    /** The workload whose front is drawn. */
    private static final String SHOWN = "flat-quarter-px";

    private static final CurveTopic TOPIC = new CurveTopic();

    /**
     * One method on the curves of one flatness.
     *
     * @param flatness in pixels
     * @param segments of a curve, on the average
     * @param error times the flatness, the largest
     * @param nanos of making and drawing a curve so often as {@link #TIMES} says; none where the
     *     planner does not know the method
     * @param chosen of each, whether the planner takes the method
     */
    record SegmentRow(
            double flatness,
            String method,
            double segments,
            double error,
            List<Double> nanos,
            List<Boolean> chosen) {
        SegmentRow {
            nanos = List.copyOf(nanos);
            chosen = List.copyOf(chosen);
        }
    }

    /** The rows, by falling flatness, in the topic's order of methods. */
    List<SegmentRow> rows() {
        var rows = new ArrayList<SegmentRow>();
        for (Workload<CurveTask> load : flattening()) rows.addAll(rows(load.inputs()));
        return rows;
    }

    private static List<Workload<CurveTask>> flattening() {
        return TOPIC.workloads().stream()
                .filter(load -> load.inputs().get(0).flatness() > 0)
                .toList();
    }

    private static List<SegmentRow> rows(List<CurveTask> tasks) {
        List<Polyline> exact =
                tasks.stream().map(task -> TOPIC.exact(task, TOPIC.mostItems())).toList();
        List<CurvePlan> plans =
                TIMES.stream()
                        .map(
                                times ->
                                        CurvePlan.of(
                                                tasks,
                                                exact,
                                                times,
                                                TOPIC.mostItems(),
                                                CurvePrices.measured(),
                                                () -> false))
                        .toList();
        return TOPIC.methods().stream()
                .map(method -> row(method.name(), method.implementation(), tasks, exact, plans))
                .toList();
    }

    private static SegmentRow row(
            String method,
            CurveTracer tracer,
            List<CurveTask> tasks,
            List<Polyline> exact,
            List<CurvePlan> plans) {
        long segments = 0;
        double error = 0;
        for (int i = 0; i < tasks.size(); i++) {
            Polyline made = TOPIC.record(tracer, tasks.get(i), TOPIC.mostItems());
            segments += made.size() - 1;
            error = Math.max(error, TOPIC.compare(tasks.get(i), exact.get(i), made).worst());
        }
        var nanos = new ArrayList<Double>();
        var chosen = new ArrayList<Boolean>();
        for (CurvePlan plan : plans)
            for (CurvePlan.MethodPolylines way : plan.ways())
                if (way.method().equals(method)) {
                    nanos.add(way.nanos(plan.times()) / tasks.size());
                    chosen.add(plan.chosen().method().equals(method));
                }
        return new SegmentRow(
                tasks.get(0).flatness(),
                method,
                (double) segments / tasks.size(),
                error,
                nanos,
                chosen);
    }

    byte[] svg(Language language) {
        return front(language).svg(ChartLook.PAPER);
    }

    byte[] png(Language language) {
        return PngFile.bytes(front(language).image(ChartLook.PAPER));
    }

    private static FrontChart front(Language language) {
        var flat =
                new ForwardingTopic<CurveTracer, CurveTask, Polyline>(TOPIC) {
                    @Override
                    public List<Workload<CurveTask>> workloads() {
                        return flattening();
                    }
                };
        Study study = StudyRunner.measure(flat, StudySettings.shortest(), step -> {}, () -> false);
        return new FrontChart(
                StudyCost.PARTS.of(study), SHOWN, StudyCost.PARTS.words(language), ChartLook.PAPER);
    }

    String csv() {
        var lines = new StringBuilder("flatness_px,method,segments_per_curve,error_of_flatness");
        for (long times : TIMES) lines.append(",ns_drawn_").append(times);
        lines.append(",planned_for\n");
        for (SegmentRow row : rows()) {
            lines.append(
                    String.format(
                            Locale.ROOT,
                            "%s,%s,%s,%s",
                            row.flatness(),
                            row.method(),
                            row.segments(),
                            row.error()));
            for (int i = 0; i < TIMES.size(); i++)
                lines.append(',').append(row.nanos().isEmpty() ? "" : row.nanos().get(i));
            lines.append(',').append(String.join(" ", planned(row))).append('\n');
        }
        return lines.toString();
    }

    private static List<String> planned(SegmentRow row) {
        var times = new ArrayList<String>();
        for (int i = 0; i < row.chosen().size(); i++)
            if (row.chosen().get(i)) times.add(String.valueOf(TIMES.get(i)));
        return times;
    }
}
