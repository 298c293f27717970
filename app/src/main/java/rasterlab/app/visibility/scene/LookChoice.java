package rasterlab.app.visibility.scene;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.app.model.TextureChange;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.DrawnDepths;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.visibility.ClipPlane;

/**
 * How a scene is drawn beside method, shading and projection.
 *
 * @param texture how textures are looked up
 * @param change how they lie
 * @param terms of the light
 * @param sides how backs are lit
 * @param cull which faces are left out
 * @param hidden what becomes of hidden wires
 * @param crease degrees below which a wire is left out, 0 to 180
 * @param cue share of the background in what is farthest, 0 to 1; 0 for none
 * @param stereo how two eyes are shown; empty for one eye
 * @param eyes their separation as a share of ρ
 * @param near the nearest depth as a share of ρ; 0 for all
 * @param far the farthest as a share of ρ, above near; infinite for all
 * @param clipPlanes that cut besides, in the world
 */
public record LookChoice(
        TextureMode texture,
        TextureChange change,
        Set<LightTerm> terms,
        Sides sides,
        Cull cull,
        HiddenLines hidden,
        double crease,
        double cue,
        Optional<Stereo.StereoMode> stereo,
        double eyes,
        double near,
        double far,
        List<ClipPlane> clipPlanes) {
    /** Everything as it usually is. */
    static final LookChoice USUAL =
            new LookChoice(
                    TextureMode.AUTO,
                    new TextureChange(Optional.empty(), Optional.empty()),
                    LightTerm.all(),
                    Sides.SCENE,
                    Cull.NONE,
                    HiddenLines.REMOVED,
                    0,
                    0,
                    Optional.empty(),
                    Stereo.USUAL,
                    0,
                    Double.POSITIVE_INFINITY,
                    List.of());

    public LookChoice {
        Bounds.require("crease", crease, 0, 180);
        Bounds.require("cue", cue, 0, 1);
        if (!(near >= 0 && near < far))
            throw new IllegalArgumentException(
                    "near must be from 0 to below far, got near %s, far %s".formatted(near, far));
        terms = Set.copyOf(terms);
        clipPlanes = ClipPlane.checked(clipPlanes);
    }

    public LookChoice withTexture(TextureMode other) {
        var draft = new Draft(this);
        draft.texture = other;
        return draft.choice();
    }

    public LookChoice withWrap(Optional<Wrap> wrap) {
        return with(new TextureChange(wrap, change.environment()));
    }

    public LookChoice withEnvironment(Optional<Mode> environment) {
        return with(new TextureChange(change.wrap(), environment));
    }

    private LookChoice with(TextureChange other) {
        var draft = new Draft(this);
        draft.change = other;
        return draft.choice();
    }

    public LookChoice withTerms(Set<LightTerm> other) {
        var draft = new Draft(this);
        draft.terms = other;
        return draft.choice();
    }

    public LookChoice withSides(Sides other) {
        var draft = new Draft(this);
        draft.sides = other;
        return draft.choice();
    }

    public LookChoice withCull(Cull other) {
        var draft = new Draft(this);
        draft.cull = other;
        return draft.choice();
    }

    public LookChoice withHidden(HiddenLines other) {
        var draft = new Draft(this);
        draft.hidden = other;
        return draft.choice();
    }

    public LookChoice withCrease(double degrees) {
        var draft = new Draft(this);
        draft.crease = degrees;
        return draft.choice();
    }

    public LookChoice withCue(double share) {
        var draft = new Draft(this);
        draft.cue = share;
        return draft.choice();
    }

    public LookChoice withStereo(Optional<Stereo.StereoMode> other) {
        var draft = new Draft(this);
        draft.stereo = other;
        return draft.choice();
    }

    public LookChoice withEyes(double share) {
        var draft = new Draft(this);
        draft.eyes = share;
        return draft.choice();
    }

    /** A near plane that would pass the far one stays before it. */
    public LookChoice withNear(double share) {
        var draft = new Draft(this);
        draft.near = Math.min(share, 0.99 * far);
        return draft.choice();
    }

    /** A far plane that would pass the near one stays behind it. */
    public LookChoice withFar(double share) {
        var draft = new Draft(this);
        draft.far = Math.max(share, near / 0.99);
        return draft.choice();
    }

    public LookChoice withClipPlanes(List<ClipPlane> other) {
        var draft = new Draft(this);
        draft.clipPlanes = other;
        return draft.choice();
    }

    /** Two eyes need perspective. */
    Optional<Stereo.StereoMode> seenStereo(Projection projection) {
        return projection == Projection.PERSPECTIVE ? stereo : Optional.empty();
    }

    Look look(String visibility, ShadingMethod shading, Projection projection, double rho) {
        Look look =
                Look.of(visibility, shading)
                        .withTexture(texture)
                        .withLight(terms, sides)
                        .withCull(cull)
                        .withClipPlanes(clipPlanes);
        if (shading == ShadingMethod.WIRE) look = look.withWire(new WireStyle(hidden, crease));
        if (cue > 0) look = look.withCue(new DepthCue(cue));
        Optional<Stereo.StereoMode> kind = seenStereo(projection);
        return kind.isPresent() ? look.withStereo(new Stereo(kind.get(), eyes * rho)) : look;
    }

    /** The depths in world units. */
    DrawnDepths depths(Projection projection, double rho) {
        DrawnDepths all = DrawnDepths.all(projection, rho);
        return new DrawnDepths(near > 0 ? near * rho : all.near(), far * rho);
    }

    /** Parts of a look, to be changed one by one. */
    private static final class Draft {
        private TextureMode texture;
        private TextureChange change;
        private Set<LightTerm> terms;
        private Sides sides;
        private Cull cull;
        private HiddenLines hidden;
        private double crease;
        private double cue;
        private Optional<Stereo.StereoMode> stereo;
        private double eyes;
        private double near;
        private double far;
        private List<ClipPlane> clipPlanes;

        Draft(LookChoice from) {
            texture = from.texture;
            change = from.change;
            terms = from.terms;
            sides = from.sides;
            cull = from.cull;
            hidden = from.hidden;
            crease = from.crease;
            cue = from.cue;
            stereo = from.stereo;
            eyes = from.eyes;
            near = from.near;
            far = from.far;
            clipPlanes = from.clipPlanes;
        }

        LookChoice choice() {
            return new LookChoice(
                    texture,
                    change,
                    terms,
                    sides,
                    cull,
                    hidden,
                    crease,
                    cue,
                    stereo,
                    eyes,
                    near,
                    far,
                    clipPlanes);
        }
    }
}
