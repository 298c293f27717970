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

    private static final Field<double[]> AMBIENT = light("ambient");
    private static final Field<double[]> DIFFUSE = light("diffuse");
    private static final Field<double[]> SPECULAR = light("specular");
    private static final Field<double[]> SENDS_AMBIENT = share("ambient");
    private static final Field<double[]> SENDS_DIFFUSE = share("diffuse");
    private static final Field<double[]> SENDS_SPECULAR = share("specular");
    private static final Field<double[]> EMISSION = Field.optional("emission", new Shares(1, 1));
    private static final Field<Double> SHININESS =
            Field.optional("shininess", Shape.number(0, SurfaceMaterial.HIGHEST_SHININESS));
    private static final Field<Attenuation> ATTENUATION =
            Field.optional("attenuation", new Terms());
    private static final Field<double[]> DIRECTION = vector("direction");
    private static final Field<Double> CUTOFF =
            Field.required("cutoff", new Cutoff()).in("degrees");
    private static final Field<Double> EXPONENT =
            Field.optional(
                    "exponent",
                    Shape.described(Shape.number(), Shape.number(0, SpotCone.HIGHEST_EXPONENT)));
    private static final Field<SpotCone> SPOT = Field.optional("spot", new Spot());

    public static final Field<SurfaceMaterial> MATERIAL = Field.required("material", new Surface());
    public static final Field<LightSource> LIGHT = Field.optional("light", new Source());
    public static final Field<double[]> GLOBAL_AMBIENT = light("global-ambient");

    private LightFormat() {}

    /** A field of three numbers. */
    public static Field<double[]> vector(String name) {
        return Field.required(name, Shape.numbers(3, 3));
    }

    private static Field<double[]> light(String name) {
        return Field.optional(name, new Shares(LightSource.BRIGHTEST, LightSource.BRIGHTEST));
    }

    /** A field for a material, which refuses a share above 1 in words of its own. */
    private static Field<double[]> share(String name) {
        return Field.optional(name, new Shares(LightSource.BRIGHTEST, 1));
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
        private final Shape<Double> gray;

        /**
         * @param highest grey that is read
         * @param told the highest share that is not refused
         */
        Shares(double highest, double told) {
            super(Shape.boundedNumbers(3, 0, told), Shape.number(0, told));
            gray = Shape.number(0, highest);
        }

        @Override
        public double[] read(ValueSource in) throws IOException {
            if (in.startsArray()) return THREE.read(in);
            double share = gray.read(in);
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
            super(Shape.object(SENDS_AMBIENT, SENDS_DIFFUSE, SENDS_SPECULAR, EMISSION, SHININESS));
        }

        @Override
        protected SurfaceMaterial made(Given given) {
            return new SurfaceMaterial(
                    given.get(SENDS_AMBIENT, new double[3]),
                    given.get(SENDS_DIFFUSE, new double[3]),
                    given.get(SENDS_SPECULAR, new double[3]),
                    given.get(EMISSION, new double[3]),
                    given.get(SHININESS, 0.0));
        }

        @Override
        protected Given value(SurfaceMaterial material) {
            return new Given()
                    .with(SENDS_AMBIENT, material.ambient())
                    .with(SENDS_DIFFUSE, material.diffuse())
                    .with(SENDS_SPECULAR, material.specular())
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
            super(Shape.boundedNumbers(3, 0, Double.MAX_VALUE));
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

    /** Half the opening of a cone, or none; another number is refused with words of its own. */
    private static final class Cutoff extends EitherShape<Double> {
        Cutoff() {
            super(Shape.number(0, 90), Shape.number(180, 180));
        }

        @Override
        public Double read(ValueSource in) throws IOException {
            return in.number();
        }

        @Override
        public void write(Double degrees, ValueSink out) throws IOException {
            out.number(degrees);
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
