package rasterlab.engine.geometry.meeting;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.LinePlane;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Where a line meets a plane.
 *
 * <p>The error is that of μ, over μ itself where it is above 1, or that of the common point p₁ +
 * μ·p*, over the larger of p₁ and μ·p*, if that is more. Up to 8·2⁻⁵³ counts as exact, as two sums
 * and a quotient are rounded; up to 10⁻⁹ serves. An answer that puts the point behind p₁, between
 * or beyond p₂ where it is not is not exact, however small its error.
 */
public final class LinePlaneTopic implements Topic<LinePlane, PlaneAndLines, Meetings> {
    private static final double CORRECT = 8 * 0x1p-53;
    private static final double USABLE = 1e-9;

    @Override
    public String name() {
        return "line-plane";
    }

    @Override
    public String lab() {
        return "coordinates";
    }

    @Override
    public Class<LinePlane> contract() {
        return LinePlane.class;
    }

    @Override
    public List<Method<LinePlane>> methods() {
        return LinePlaneMethods.all();
    }

    @Override
    public List<Hazard<PlaneAndLines>> hazards() {
        return LinePlaneInputs.hazards();
    }

    @Override
    public List<Workload<PlaneAndLines>> workloads() {
        return LinePlaneInputs.workloads();
    }

    @Override
    public List<Mutant<LinePlane>> mutants() {
        return LinePlaneMutants.all();
    }

    @Override
    public Meetings run(LinePlane method, PlaneAndLines input, int limit) {
        Meetings all = answers(input, method);
        if (all.size() > limit) throw new LimitReached(limit, all.first(limit));
        return all;
    }

    private static Meetings answers(PlaneAndLines input, LinePlane method) {
        var mu = new double[input.size()];
        Arrays.setAll(mu, i -> input.mu(method, i));
        return Meetings.of(mu, input);
    }

    @Override
    public long spend(LinePlane method, PlaneAndLines input) {
        double sum = 0;
        for (int i = 0; i < input.size(); i++) sum += input.mu(method, i);
        // Hardly ever true, but the compiler cannot know: it must compute the answers.
        return sum == Math.PI ? 0 : input.size();
    }

    @Override
    public Meetings exact(PlaneAndLines input, int limit) {
        return ExactMeeting.all(input).first(limit);
    }

    @Override
    public Deviation compare(PlaneAndLines input, Meetings exact, Meetings actual) {
        return exact.deviation(input, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT && deviation.missing() == 0 && deviation.extra() == 0;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    @Override
    public String item() {
        return "line";
    }

    @Override
    public String errorUnit() {
        return "of p* or μ";
    }

    @Override
    public Format<LinePlane, PlaneAndLines, Meetings> format() {
        return new LinePlaneFormat(this);
    }
}
