// The state of one contact node.
#pragma once

namespace Amontons
{
  enum class ContactState : char
  {
    open,
    slip, // closed, free to move tangentially (all closed nodes of frictionless contact)
    stick // closed, held in all directions (tied interfaces)
  };
} // namespace Amontons
