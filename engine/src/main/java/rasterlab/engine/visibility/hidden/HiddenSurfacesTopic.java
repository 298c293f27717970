package rasterlab.engine.visibility.hidden;

import java.util.List;
import java.util.Map;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.exact.ExactVisibility;

/**
 * The face seen at each pixel, by every visibility method, held against {@link ExactVisibility}.
 *
 * <p>Up to 0.05 % of the pixels may differ: a pixel's centre may lie on an edge within rounding,
 * and two faces may meet in it. Up to 1 % is usable.
 */
public final class HiddenSurfacesTopic implements Topic<Visibility, SurfaceView, FacePicture> {
    private static final double CORRECT = 0.05;
    private static final double USABLE = 1;

    /** The farthest that a corner may be from the eye, in lengths of ρ. */
    private static final int FARTHEST = 1000;

    private final Visibilities visibilities = new Visibilities();

    @Override
    public String name() {
        return "hidden-surfaces";
    }

    @Override
    public String lab() {
        return "visibility";
    }

    @Override
    public Class<Visibility> contract() {
        return Visibility.class;
    }

    @Override
    public List<Method<Visibility>> methods() {
        return visibilities.methods();
    }

    @Override
    public List<Hazard<SurfaceView>> hazards() {
        return HiddenSurfacesHazards.all(methods());
    }

    @Override
    public List<Workload<SurfaceView>> workloads() {
        return HiddenSurfacesWorkloads.all();
    }

    @Override
    public List<Mutant<Visibility>> mutants() {
        return HiddenSurfacesMutants.all();
    }

    @Override
    public FacePicture run(Visibility method, SurfaceView input, int limit) {
        FacePicture picture = DrawnFaces.by(method, input).picture();
        if (input.width() * input.height() > limit) throw new LimitReached(limit, picture);
        return picture;
    }

    @Override
    public long spend(Visibility method, SurfaceView input) {
        var out = new Raster(input.width(), input.height());
        method.draw(input.view(), FacePicture.NUMBERS, out, () -> false);
        return out.argb().length;
    }

    @Override
    public FacePicture exact(SurfaceView input, int limit) {
        return run(new ExactVisibility(), input, Integer.MAX_VALUE);
    }

    @Override
    public Deviation compare(SurfaceView input, FacePicture exact, FacePicture actual) {
        return exact.deviation(actual);
    }

    /**
     * {@inheritDoc} Corners are turned and cut in doubles: one that is {@value #FARTHEST} times as
     * far from the eye's centre of turn as the eye is off by so much that edges miss pixels.
     */
    @Override
    public boolean isPromised(SurfaceView input) {
        double farthest = FARTHEST * input.camera().rho();
        Mesh mesh = input.mesh();
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                double most = Math.max(Math.abs(mesh.x(v)), Math.abs(mesh.y(v)));
                if (Math.max(most, Math.abs(mesh.z(v))) > farthest) return false;
            }
        return true;
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    @Override
    public Map<String, Long> operations(Visibility method, SurfaceView input) {
        return DrawnFaces.by(method, input).work().operations();
    }

    /** {@inheritDoc} A picture is answered whole: the most that one may have. */
    @Override
    public int mostItems() {
        return Raster.LARGEST_SIDE * Raster.LARGEST_SIDE;
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "% of the pixels";
    }

    @Override
    public Format<Visibility, SurfaceView, FacePicture> format() {
        return new HiddenSurfacesFormat(this);
    }
}
