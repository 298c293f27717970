package rasterlab.app.opengl.state;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** States that belong together, in the order in which OpenGL works. */
public enum Group {
    SCENE,
    LIGHT,
    MATERIAL,
    POLYGON,
    TEXTURE,
    PIXEL;

    /** Lower-case name, part of keys and component names. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The group's states in the order of {@link Setting}. */
    public List<Setting> settings() {
        return Arrays.stream(Setting.values()).filter(each -> each.group() == this).toList();
    }
}
