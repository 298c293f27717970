package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Eight places at a time, each as {@link PlainLight} has it; arrays have room for whole eights.
 *
 * <p>Several loops, as {@link VectorLoops} explains.
 */
final class VectorLight implements LightLoops {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final int LANES = FLOATS.length();

    @Override
    public void cosines(
            int n,
            float[] light,
            float[] x,
            float[] y,
            float[] z,
            float[] nx,
            float[] ny,
            float[] nz,
            float[] far,
            float[] along) {
        placesInLanes(n, light[0], light[1], light[2], x, y, z, nx, ny, nz, far, along);
        normalsInLanes(n, light[0], light[1], light[2], nx, ny, nz, far, along, y, z);
        divideInLanes(n, x, y, z, along, nx, ny);
    }

    /** far = |p|, along = n·p, x = |h|²·p². */
    private static void placesInLanes(
            int n,
            float lx,
            float ly,
            float lz,
            float[] x,
            float[] y,
            float[] z,
            float[] nx,
            float[] ny,
            float[] nz,
            float[] far,
            float[] along) {
        for (int i = 0; i < n; i += LANES) {
            FloatVector px = FloatVector.fromArray(FLOATS, x, i);
            FloatVector py = FloatVector.fromArray(FLOATS, y, i);
            FloatVector pz = FloatVector.fromArray(FLOATS, z, i);
            px.mul(FloatVector.fromArray(FLOATS, nx, i))
                    .add(py.mul(FloatVector.fromArray(FLOATS, ny, i)))
                    .add(pz.mul(FloatVector.fromArray(FLOATS, nz, i)))
                    .intoArray(along, i);
            FloatVector length = px.mul(px).add(py.mul(py)).add(pz.mul(pz)).sqrt();
            FloatVector twice = px.mul(lx).add(py.mul(ly)).add(pz.mul(lz)).mul(2);
            length.intoArray(far, i);
            length.mul(ROOM).sub(twice).mul(length).intoArray(x, i);
        }
    }

    /** length = |n|, toLight = n·l, along = max(0, n·h·|p|). */
    private static void normalsInLanes(
            int n,
            float lx,
            float ly,
            float lz,
            float[] nx,
            float[] ny,
            float[] nz,
            float[] far,
            float[] along,
            float[] length,
            float[] toLight) {
        for (int i = 0; i < n; i += LANES) {
            FloatVector x = FloatVector.fromArray(FLOATS, nx, i);
            FloatVector y = FloatVector.fromArray(FLOATS, ny, i);
            FloatVector z = FloatVector.fromArray(FLOATS, nz, i);
            x.mul(x).add(y.mul(y)).add(z.mul(z)).sqrt().intoArray(length, i);
            FloatVector cosine = x.mul(lx).add(y.mul(ly)).add(z.mul(lz));
            cosine.intoArray(toLight, i);
            FloatVector halfway =
                    cosine.mul(FloatVector.fromArray(FLOATS, far, i))
                            .sub(FloatVector.fromArray(FLOATS, along, i));
            halfway.add(halfway.abs()).mul(0.5f).intoArray(along, i);
        }
    }

    private static void divideInLanes(
            int n,
            float[] halfway,
            float[] length,
            float[] toLight,
            float[] along,
            float[] nx,
            float[] ny) {
        for (int i = 0; i < n; i += LANES) {
            FloatVector h = FloatVector.fromArray(FLOATS, halfway, i);
            FloatVector inverse =
                    FloatVector.broadcast(FLOATS, 1)
                            .div(h.mul(FloatVector.fromArray(FLOATS, length, i)));
            FloatVector cosine = h.mul(inverse).mul(FloatVector.fromArray(FLOATS, toLight, i));
            FloatVector diffuse = cosine.add(cosine.abs()).mul(0.5f);
            diffuse.intoArray(nx, i);
            FloatVector part = inverse.mul(FloatVector.fromArray(FLOATS, along, i));
            FloatVector lit = diffuse.mul(LIT);
            VectorMask<Float> full = lit.compare(VectorOperators.GT, 1f);
            part.mul(part).mul(h).mul(lit.blend(1f, full)).intoArray(ny, i);
        }
    }

    @Override
    public void channel(
            int n, float steady, float lit, float[] diffuse, float[] highlight, float[] out) {
        channelInLanes(n, steady, lit, diffuse, highlight, out);
    }

    private static void channelInLanes(
            int n, float steady, float lit, float[] diffuse, float[] highlight, float[] out) {
        for (int i = 0; i < n; i += LANES) {
            FloatVector sum =
                    FloatVector.fromArray(FLOATS, diffuse, i)
                            .mul(lit)
                            .add(steady)
                            .add(FloatVector.fromArray(FLOATS, highlight, i));
            sum.blend(1f, sum.compare(VectorOperators.GT, 1f)).intoArray(out, i);
        }
    }
}
