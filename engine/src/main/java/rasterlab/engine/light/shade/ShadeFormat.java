package rasterlab.engine.light.shade;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.light.LightFormat;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.shade.Terms.Addition;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** A shaded point from outside: its directions and its light; {@code intensity} out. */
final class ShadeFormat extends Format<PointShader, LitPoints, Shades> {
    private static final Shape<?> RGB = Shape.numbersOrNull(3, 3);
    private static final Field<double[]> NORMAL = LightFormat.vector("normal");
    private static final Field<double[]> TO_LIGHT = LightFormat.vector("to-light");
    private static final Field<double[]> TO_EYE = LightFormat.vector("to-eye");
    private static final Field<Double> DISTANCE =
            Field.optional("distance", Shape.number(0, Double.MAX_VALUE));
    private static final Field<?> INTENSITY = Field.required("intensity", RGB);
    private static final Field<?> TERMS =
            Field.optional(
                    "terms",
                    Shape.object(
                            Field.required("emission", RGB),
                            Field.required("global-ambient", RGB),
                            Field.required("ambient", RGB),
                            Field.required("diffuse", RGB),
                            Field.required("specular", RGB),
                            Field.required("attenuation", Shape.number()),
                            Field.required("cone", Shape.number())));

    ShadeFormat(Topic<PointShader, LitPoints, Shades> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(
                NORMAL,
                TO_LIGHT,
                TO_EYE,
                LightFormat.MATERIAL,
                LightFormat.LIGHT,
                DISTANCE,
                LightFormat.GLOBAL_AMBIENT);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(INTENSITY, TERMS);
    }

    @Override
    public String reads() {
        return """
            {"normal":[x,y,z], "to-light":[x,y,z], "to-eye":[x,y,z], "material":M, \
            "light":L, "distance":d, "global-ambient":C}, the last three being optional;"""
                + " "
                + LightFormat.WORDS
                + """
            ; L's own ambient light is weakened by its distance as the rest of L is, \
            1/(c + l·d + q·d²), global-ambient is not""";
    }

    @Override
    public String answers() {
        return """
            {"intensity":[r,g,b], "terms":{"emission":[r,g,b], "global-ambient":[...], \
            "ambient":[...], "diffuse":[...], "specular":[...], "attenuation":f, "cone":f}}""";
    }

    /** {@inheritDoc} Without a distance the light stands where {@code to-light} ends. */
    @Override
    public LitPoints read(Given given) {
        double[] toLight = given.get(TO_LIGHT);
        try {
            return new LitPoints(
                    List.of(
                            new LitPoint(
                                    given.get(NORMAL),
                                    toLight,
                                    given.get(TO_EYE),
                                    given.find(DISTANCE)
                                            .orElseGet(() -> UnitVector.length(toLight)),
                                    given.get(LightFormat.MATERIAL),
                                    LightFormat.light(given),
                                    LightFormat.globalAmbient(given))));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(LitPoints points) {
        if (points.points().size() > 1)
            throw new IllegalArgumentException(
                    "one point is told at a time, got " + points.points().size());
        LitPoint point = points.points().get(0);
        return new Given()
                .with(NORMAL, point.normal())
                .with(TO_LIGHT, point.toLight())
                .with(TO_EYE, point.toEye())
                .with(LightFormat.MATERIAL, point.material())
                .with(LightFormat.LIGHT, point.light())
                .with(DISTANCE, point.distance())
                .with(LightFormat.GLOBAL_AMBIENT, point.globalAmbient());
    }

    /** {@inheritDoc} One for each point. */
    @Override
    public List<LitPoints> singles(LitPoints points) {
        return points.points().stream().map(point -> new LitPoints(List.of(point))).toList();
    }

    /** {@inheritDoc} From outside one point is shaded; of several specular terms by the first. */
    @Override
    public void write(LitPoints points, Shades shades, ValueSink out) throws IOException {
        double[] rgb = shades.rgb().values().iterator().next();
        out.numbers(INTENSITY.name(), Arrays.copyOf(rgb, 3));
    }

    @Override
    protected Written answered(Call<PointShader> call, LitPoints points) {
        LitPoint point = points.points().get(0);
        double[] intensity = call.method().intensity(point);
        Terms terms = call.method() instanceof TermShader termed ? termed.terms(point) : null;
        if (call.steps() && terms == null) throw call.noSteps();
        return answer(
                points,
                new Shades(Map.of(call.method().reflection(), intensity)),
                terms == null ? null : out -> write(terms, out),
                call.steps() ? steps(terms, intensity) : null);
    }

    /** A term added. */
    private record Step(Addition addition) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("step", addition.term());
            out.numbers("value", addition.value());
            out.numbers("sum", addition.sum());
        }
    }

    /** The terms one by one, and the cut where there is something to cut. */
    private static RecordedSteps steps(Terms terms, double[] intensity) {
        List<Addition> steps = terms.additions();
        if (!Arrays.equals(terms.sum(), intensity))
            steps.add(new Addition("cut to [0, 1]", intensity, intensity));
        return RecordedSteps.plain(steps.stream().map(Step::new).toList());
    }

    private static void write(Terms terms, ValueSink out) throws IOException {
        out.name(TERMS.name());
        out.startObject();
        out.numbers("emission", terms.emission());
        out.numbers("global-ambient", terms.globalAmbient());
        out.numbers("ambient", terms.ambient());
        out.numbers("diffuse", terms.diffuse());
        out.numbers("specular", terms.specular());
        out.number("attenuation", terms.attenuation());
        out.number("cone", terms.cone());
        out.endObject();
    }
}
