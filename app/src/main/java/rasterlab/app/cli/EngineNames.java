package rasterlab.app.cli;

import java.util.Iterator;
import java.util.List;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.scene.catalogue.Scenes;

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

    static final class OfScenes extends EngineNames {
        OfScenes() {
            super(Scenes.names());
        }
    }

    static final class OfVisibilities extends EngineNames {
        OfVisibilities() {
            super(Renderer.visibilities());
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
}
