package rasterlab.grader.storage

import org.jdbi.v3.core.argument.AbstractArgumentFactory
import org.jdbi.v3.core.argument.Argument
import org.jdbi.v3.core.config.ConfigRegistry
import java.sql.Types

/** Writes U+2400, the picture of a NUL, for each NUL in a text: PostgreSQL stores none, and no program compiles with one. */
internal object TextWithoutNul : AbstractArgumentFactory<String>(Types.VARCHAR) {
    override fun build(
        value: String,
        config: ConfigRegistry,
    ) = Argument { position, statement, _ -> statement.setString(position, value.replace('\u0000', '\u2400')) }
}
