package rasterlab.app.opengl.call;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.lwjgl.opengl.GL11;
import rasterlab.engine.texture.Texture;

/**
 * The objects that a context keeps between frames: textures and display lists. Dies with its
 * context.
 */
public final class GlObjects {
    /**
     * The most objects that are kept, more than a user compares; the oldest are no use to anybody.
     */
    private static final int MOST = 24;

    private final Map<Texture, Integer> textures = new HashMap<>();
    private final Set<Texture> uploaded = new HashSet<>();
    private final Map<String, Integer> lists = new HashMap<>();

    /** Binds the texture, which gets a name if it has none yet. */
    void bind(Texture texture) {
        if (textures.size() >= MOST && !textures.containsKey(texture)) deleteTextures();
        int name = textures.computeIfAbsent(texture, unknown -> GL11.glGenTextures());
        GL11.glBindTexture(GL11.GL_TEXTURE_2D, name);
    }

    /** Uploads the texture that is bound, unless OpenGL has it already. */
    void upload(Texture texture, Runnable levels) {
        if (uploaded.add(texture)) levels.run();
    }

    /** The number of a list, which is filled by {@code content} if it is not yet known. */
    int list(String name, Runnable content) {
        Integer known = lists.get(name);
        if (known != null) return known;
        int list = GL11.glGenLists(1);
        GL11.glNewList(list, GL11.GL_COMPILE);
        content.run();
        GL11.glEndList();
        lists.put(name, list);
        return list;
    }

    private void deleteTextures() {
        textures.values().forEach(GL11::glDeleteTextures);
        textures.clear();
        uploaded.clear();
    }

    /** Gives everything back; in the context that has it. */
    public void delete() {
        deleteTextures();
        lists.values().forEach(list -> GL11.glDeleteLists(list, 1));
        lists.clear();
    }
}
