package rasterlab.engine.light;

import java.io.IOException;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.MadeShape;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;

/** Materials and lights from outside; a colour is three shares or one number for all. */
public final class LightFormat {
    /** The meaning of M, L and C in an input that is told to people. */
    public static final String WORDS =
            """
            M = {"ambient":C, "diffuse":C, "specular":C, "emission":C, "shininess":n}, L = \
            {"ambient":C, "diffuse":C, "specular":C, "attenuation":[c,l,q], "spot":\
            {"direction":[x,y,z], "cutoff":degrees, "exponent":e}}, each field of M and L being \
            optional, C = [r,g,b] or one number for all three""";

    private static final Field<double[]> AMBIENT = colour("ambient", LightSource.BRIGHTEST);
    private static final Field<double[]> DIFFUSE = colour("diffuse", LightSource.BRIGHTEST);
    private static final Field<double[]> SPECULAR = colour("specular", LightSource.BRIGHTEST);
    private static final Field<double[]> EMISSION = colour("emission", 1);
    private static final Field<Double> SHININESS =
            Field.optional("shininess", Shape.number(0, SurfaceMaterial.HIGHEST_SHININESS));
    private static final Field<Attenuation> ATTENUATION =
            Field.optional("attenuation", new Terms());
    private static final Field<double[]> DIRECTION = vector("direction");
    private static final Field<Double> CUTOFF =
            Field.required("cutoff", Shape.number()).in("degrees");
    private static final Field<Double> EXPONENT = Field.optional("exponent", Shape.number());
    private static final Field<SpotCone> SPOT = Field.optional("spot", new Spot());

    public static final Field<SurfaceMaterial> MATERIAL = Field.required("material", new Surface());
    public static final Field<LightSource> LIGHT = Field.optional("light", new Source());
    public static final Field<double[]> GLOBAL_AMBIENT =
            colour("global-ambient", LightSource.BRIGHTEST);

    private LightFormat() {}

    /** A field of three numbers. */
    public static Field<double[]> vector(String name) {
        return Field.required(name, Shape.numbers(3, 3));
    }

    private static Field<double[]> colour(String name, double highest) {
        return Field.optional(name, new Shares(highest));
    }

    /** The light of {@code given}, white where there is none. */
    public static LightSource light(Given given) {
        return given.find(LIGHT).orElseGet(LightSource::white);
    }

    /** The light from everywhere of {@code given}, none where there is none. */
    public static double[] globalAmbient(Given given) {
        return given.get(GLOBAL_AMBIENT, new double[3]);
    }

    /** A colour. */
    private static final class Shares extends EitherShape<double[]> {
        private static final Shape<double[]> THREE = Shape.numbers(3, 3);
        private final Shape<Double> grey;

        Shares(double highest) {
            this(Shape.number(0, highest));
        }

        private Shares(Shape<Double> grey) {
            super(THREE, grey);
            this.grey = grey;
        }

        @Override
        public double[] read(ValueSource in) throws IOException {
            if (in.startsArray()) return THREE.read(in);
            double share = grey.read(in);
            return new double[] {share, share, share};
        }

        @Override
        public void write(double[] shares, ValueSink out) throws IOException {
            THREE.write(shares, out);
        }
    }

    /** A material. */
    private static final class Surface extends MadeShape<Given, SurfaceMaterial> {
        Surface() {
            super(Shape.object(AMBIENT, DIFFUSE, SPECULAR, EMISSION, SHININESS));
        }

        @Override
        protected SurfaceMaterial made(Given given) {
            return new SurfaceMaterial(
                    given.get(AMBIENT, new double[3]),
                    given.get(DIFFUSE, new double[3]),
                    given.get(SPECULAR, new double[3]),
                    given.get(EMISSION, new double[3]),
                    given.get(SHININESS, 0.0));
        }

        @Override
        protected Given value(SurfaceMaterial material) {
            return new Given()
                    .with(AMBIENT, material.ambient())
                    .with(DIFFUSE, material.diffuse())
                    .with(SPECULAR, material.specular())
                    .with(EMISSION, material.emission())
                    .with(SHININESS, material.shininess());
        }
    }

    /** A light. */
    private static final class Source extends MadeShape<Given, LightSource> {
        Source() {
            super(Shape.object(AMBIENT, DIFFUSE, SPECULAR, ATTENUATION, SPOT));
        }

        @Override
        protected LightSource made(Given given) {
            LightSource white = LightSource.white();
            return new LightSource(
                    given.get(AMBIENT, white.ambient()),
                    given.get(DIFFUSE, white.diffuse()),
                    given.get(SPECULAR, white.specular()),
                    given.get(ATTENUATION, white.attenuation()),
                    given.get(SPOT, white.cone()));
        }

        @Override
        protected Given value(LightSource light) {
            return new Given()
                    .with(AMBIENT, light.ambient())
                    .with(DIFFUSE, light.diffuse())
                    .with(SPECULAR, light.specular())
                    .with(ATTENUATION, light.attenuation())
                    .with(SPOT, light.cone());
        }
    }

    /** How a light weakens with its distance. */
    private static final class Terms extends MadeShape<double[], Attenuation> {
        Terms() {
            super(Shape.numbers(3, 3));
        }

        @Override
        protected Attenuation made(double[] terms) {
            return new Attenuation(terms[0], terms[1], terms[2]);
        }

        @Override
        protected double[] value(Attenuation of) {
            return new double[] {of.constant(), of.linear(), of.quadratic()};
        }
    }

    /** The cone of a spotlight. */
    private static final class Spot extends MadeShape<Given, SpotCone> {
        Spot() {
            super(Shape.object(DIRECTION, CUTOFF, EXPONENT));
        }

        @Override
        protected SpotCone made(Given given) {
            return new SpotCone(given.get(DIRECTION), given.get(CUTOFF), given.get(EXPONENT, 0.0));
        }

        @Override
        protected Given value(SpotCone cone) {
            return new Given()
                    .with(DIRECTION, cone.direction())
                    .with(CUTOFF, cone.cutoff())
                    .with(EXPONENT, cone.exponent());
        }
    }
}
