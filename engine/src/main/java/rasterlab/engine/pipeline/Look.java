package rasterlab.engine.pipeline;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.Visibility;

/**
 * How a scene is drawn, wherever it is seen from.
 *
 * @param visibility one of {@link Renderer#visibilities()}, {@link Renderer#SURFACES} or {@link
 *     Renderer#REFERENCE}; or the name of {@code given}
 * @param given the method itself, where it is none that the renderer knows by a name
 * @param shading of the faces
 * @param texture how the faces' textures are looked up
 * @param terms the terms of light that are seen
 * @param sides how backs are lit
 * @param cull which faces are left out
 * @param wire how edges are drawn, where they are all that is drawn
 * @param outline whether faces get edges of 0.96 of their tone; painters only
 * @param cue how things fade with depth
 * @param stereo whether two eyes see the scene
 * @param clipPlanes planes in the world that cut off what is beyond them
 * @param savings what the triangle pipeline may leave out
 */
public record Look(
        String visibility,
        Optional<Visibility> given,
        ShadingMethod shading,
        TextureMode texture,
        Set<LightTerm> terms,
        Sides sides,
        Cull cull,
        WireStyle wire,
        boolean outline,
        Optional<DepthCue> cue,
        Optional<Stereo> stereo,
        List<ClipPlane> clipPlanes,
        Savings savings) {
    public Look {
        boolean outlined = outline && shading != ShadingMethod.WIRE;
        if (given.isEmpty()) Renderer.checkNames(visibility, outlined);
        else Renderer.checkGiven(visibility, given.get(), outlined);
        clipPlanes = ClipPlane.checked(clipPlanes);
        terms = terms.isEmpty() ? Set.of() : Set.copyOf(EnumSet.copyOf(terms));
    }

    /** Everything that is not named as it usually is. */
    public static Look of(String visibility, ShadingMethod shading) {
        return new Look(
                visibility,
                Optional.empty(),
                shading,
                TextureMode.AUTO,
                LightTerm.all(),
                Sides.SCENE,
                Cull.NONE,
                WireStyle.USUAL,
                false,
                Optional.empty(),
                Optional.empty(),
                List.of(),
                Savings.NONE);
    }

    public Look withVisibility(String other) {
        var draft = new Draft(this);
        draft.visibility = other;
        draft.given = Optional.empty();
        return draft.look();
    }

    /**
     * This look drawn by a method that the renderer does not know.
     *
     * @param name what it is called; none of the renderer's names
     */
    public Look withVisibility(String name, Visibility method) {
        var draft = new Draft(this);
        draft.visibility = name;
        draft.given = Optional.of(method);
        return draft.look();
    }

    public Look withShading(ShadingMethod other) {
        var draft = new Draft(this);
        draft.shading = other;
        return draft.look();
    }

    public Look withTexture(TextureMode other) {
        var draft = new Draft(this);
        draft.texture = other;
        return draft.look();
    }

    /** This look lit by some terms only, backs as told. */
    public Look withLight(Set<LightTerm> seen, Sides backs) {
        var draft = new Draft(this);
        draft.terms = seen;
        draft.sides = backs;
        return draft.look();
    }

    public Look withCull(Cull other) {
        var draft = new Draft(this);
        draft.cull = other;
        return draft.look();
    }

    public Look withWire(WireStyle other) {
        var draft = new Draft(this);
        draft.wire = other;
        return draft.look();
    }

    /**
     * This look with outlined faces.
     *
     * @throws IllegalArgumentException if the visibility method draws none
     */
    public Look withOutline() {
        var draft = new Draft(this);
        draft.outline = true;
        return draft.look();
    }

    public Look withCue(DepthCue other) {
        var draft = new Draft(this);
        draft.cue = Optional.of(other);
        return draft.look();
    }

    public Look withStereo(Stereo other) {
        var draft = new Draft(this);
        draft.stereo = Optional.of(other);
        return draft.look();
    }

    /** This look cut by planes in the world. */
    public Look withClipPlanes(List<ClipPlane> other) {
        var draft = new Draft(this);
        draft.clipPlanes = other;
        return draft.look();
    }

    /** This look, of which something proved may be left out. */
    public Look withSavings(Savings other) {
        var draft = new Draft(this);
        draft.savings = other;
        return draft.look();
    }

    /**
     * @throws IllegalArgumentException for what only faces have: other shading than Phong's, edges,
     *     culling, mipmaps, fading
     */
    void requireSurfaces() {
        if (shading != ShadingMethod.PHONG && shading != ShadingMethod.AUTO)
            throw onlyFaces("shading " + shading.code(), "phong or auto");
        if (cull != Cull.NONE) throw onlyFaces("culling", "none");
        if (texture == TextureMode.MIPMAP || texture == TextureMode.AFFINE_NEAREST)
            throw onlyFaces("texture " + texture.code(), "nearest, linear, none or auto");
        if (cue.isPresent()) throw onlyFaces("depth cue", "none");
    }

    private static IllegalArgumentException onlyFaces(String what, String allowed) {
        return new IllegalArgumentException(
                "%s needs faces; surfaces are drawn with %s".formatted(what, allowed));
    }

    /** Parts of a look, to be changed one by one. */
    private static final class Draft {
        private String visibility;
        private Optional<Visibility> given;
        private ShadingMethod shading;
        private TextureMode texture;
        private Set<LightTerm> terms;
        private Sides sides;
        private Cull cull;
        private WireStyle wire;
        private boolean outline;
        private Optional<DepthCue> cue;
        private Optional<Stereo> stereo;
        private List<ClipPlane> clipPlanes;
        private Savings savings;

        Draft(Look from) {
            visibility = from.visibility;
            given = from.given;
            shading = from.shading;
            texture = from.texture;
            terms = from.terms;
            sides = from.sides;
            cull = from.cull;
            wire = from.wire;
            outline = from.outline;
            cue = from.cue;
            stereo = from.stereo;
            clipPlanes = from.clipPlanes;
            savings = from.savings;
        }

        Look look() {
            return new Look(
                    visibility,
                    given,
                    shading,
                    texture,
                    terms,
                    sides,
                    cull,
                    wire,
                    outline,
                    cue,
                    stereo,
                    clipPlanes,
                    savings);
        }
    }
}
