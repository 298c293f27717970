package rasterlab.engine.pipeline;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.visibility.ClipPlane;

/**
 * How a scene is drawn, wherever it is seen from.
 *
 * @param visibility one of {@link Renderer#visibilities()}
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
 */
public record Look(
        String visibility,
        ShadingMethod shading,
        TextureMode texture,
        Set<LightTerm> terms,
        Sides sides,
        Cull cull,
        WireStyle wire,
        boolean outline,
        Optional<DepthCue> cue,
        Optional<Stereo> stereo,
        List<ClipPlane> clipPlanes) {
    public Look {
        Renderer.checkNames(visibility, outline && shading != ShadingMethod.WIRE);
        clipPlanes = ClipPlane.checked(clipPlanes);
        terms = terms.isEmpty() ? Set.of() : Set.copyOf(EnumSet.copyOf(terms));
    }

    /** Everything that is not named as it usually is. */
    public static Look of(String visibility, ShadingMethod shading) {
        return new Look(
                visibility,
                shading,
                TextureMode.AUTO,
                LightTerm.all(),
                Sides.SCENE,
                Cull.NONE,
                WireStyle.USUAL,
                false,
                Optional.empty(),
                Optional.empty(),
                List.of());
    }

    public Look withVisibility(String other) {
        return new Look(
                other,
                shading,
                texture,
                terms,
                sides,
                cull,
                wire,
                outline,
                cue,
                stereo,
                clipPlanes);
    }

    public Look withShading(ShadingMethod other) {
        return new Look(
                visibility,
                other,
                texture,
                terms,
                sides,
                cull,
                wire,
                outline,
                cue,
                stereo,
                clipPlanes);
    }

    public Look withTexture(TextureMode other) {
        return new Look(
                visibility,
                shading,
                other,
                terms,
                sides,
                cull,
                wire,
                outline,
                cue,
                stereo,
                clipPlanes);
    }

    /** Lit by some terms only, backs as told. */
    public Look withLight(Set<LightTerm> seen, Sides backs) {
        return new Look(
                visibility,
                shading,
                texture,
                seen,
                backs,
                cull,
                wire,
                outline,
                cue,
                stereo,
                clipPlanes);
    }

    public Look withCull(Cull other) {
        return new Look(
                visibility,
                shading,
                texture,
                terms,
                sides,
                other,
                wire,
                outline,
                cue,
                stereo,
                clipPlanes);
    }

    public Look withWire(WireStyle other) {
        return new Look(
                visibility,
                shading,
                texture,
                terms,
                sides,
                cull,
                other,
                outline,
                cue,
                stereo,
                clipPlanes);
    }

    /**
     * With outlined faces.
     *
     * @throws IllegalArgumentException if the visibility method draws none
     */
    public Look withOutline() {
        return new Look(
                visibility,
                shading,
                texture,
                terms,
                sides,
                cull,
                wire,
                true,
                cue,
                stereo,
                clipPlanes);
    }

    public Look withCue(DepthCue other) {
        return new Look(
                visibility,
                shading,
                texture,
                terms,
                sides,
                cull,
                wire,
                outline,
                Optional.of(other),
                stereo,
                clipPlanes);
    }

    public Look withStereo(Stereo other) {
        return new Look(
                visibility,
                shading,
                texture,
                terms,
                sides,
                cull,
                wire,
                outline,
                cue,
                Optional.of(other),
                clipPlanes);
    }

    /** Cut by planes in the world. */
    public Look withClipPlanes(List<ClipPlane> other) {
        return new Look(
                visibility,
                shading,
                texture,
                terms,
                sides,
                cull,
                wire,
                outline,
                cue,
                stereo,
                other);
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
}
