package rasterlab.app.cli.render;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.naming.Named;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.Wrap;

/** The engine's names as help lists them and the shell completes them. */
abstract class EngineNames implements Iterable<String> {
    private final List<String> names;

    private EngineNames(List<String> names) {
        this.names = names;
    }

    @Override
    public Iterator<String> iterator() {
        return names.iterator();
    }

    /** A constant's name as on the command line: lower-case with hyphens. */
    private static String code(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static List<String> codes(Enum<?>... constants) {
        return Arrays.stream(constants).map(EngineNames::code).toList();
    }

    /**
     * @param kind what the constants are, for the message
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    static <E extends Enum<E>> E constant(String kind, E[] constants, String name) {
        return Named.find(kind, name, List.of(constants), EngineNames::code);
    }

    static final class OfScenes extends EngineNames {
        OfScenes() {
            super(Scenes.names());
        }
    }

    static final class OfVisibilities extends EngineNames {
        OfVisibilities() {
            super(
                    Stream.concat(Renderer.visibilities().stream(), Stream.of(Renderer.SURFACES))
                            .toList());
        }
    }

    static final class OfShadings extends EngineNames {
        OfShadings() {
            super(Renderer.shadings());
        }
    }

    static final class OfProjections extends EngineNames {
        OfProjections() {
            super(Renderer.projections());
        }
    }

    static final class OfTextureModes extends EngineNames {
        OfTextureModes() {
            super(TextureMode.names());
        }
    }

    static final class OfLightTerms extends EngineNames {
        OfLightTerms() {
            super(LightTerm.names());
        }
    }

    static final class OfCulls extends EngineNames {
        OfCulls() {
            super(Cull.names());
        }
    }

    static final class OfUpAxes extends EngineNames {
        OfUpAxes() {
            super(UpAxis.names());
        }
    }

    static final class OfHiddenLines extends EngineNames {
        OfHiddenLines() {
            super(HiddenLines.names());
        }
    }

    static final class OfStereoKinds extends EngineNames {
        OfStereoKinds() {
            super(Stereo.StereoMode.names());
        }
    }

    static final class OfWraps extends EngineNames {
        OfWraps() {
            super(codes(Wrap.values()));
        }
    }

    static final class OfEnvironments extends EngineNames {
        OfEnvironments() {
            super(codes(TextureEnvironment.Mode.values()));
        }
    }
}
